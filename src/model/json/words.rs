//! Enums that a scene file writes as words.

/// Enum that a scene file writes as one of a few words.
pub trait Words: Copy + 'static {
    /// All words, in the order of the variants.
    const WORDS: &'static [&'static str];

    /// Variant of a word.
    fn from_word(word: &str) -> Option<Self>;

    /// Word of a variant.
    fn word(self) -> &'static str;
}

/// Defines an enum whose variants are words in the scene file.
///
/// serde's own derive would also accept `{"2d": null}` for `"2d"`, and answers a number with "expected value". These
/// enums accept only a string, and name the known words.
macro_rules! words {
    ($(#[$outer:meta])* pub enum $name:ident { $($(#[$attribute:meta])* $variant:ident = $word:literal,)+ }) => {
        $(#[$outer])*
        #[derive(Debug, Clone, Copy, PartialEq, Eq)]
        #[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
        pub enum $name { $($(#[$attribute])* #[cfg_attr(feature = "schema", schemars(rename = $word))] $variant,)+ }

        impl $crate::model::json::words::Words for $name {
            const WORDS: &'static [&'static str] = &[$($word),+];

            fn from_word(word: &str) -> Option<$name> {
                match word {
                    $($word => Some($name::$variant),)+
                    _ => None,
                }
            }

            fn word(self) -> &'static str {
                match self { $($name::$variant => $word,)+ }
            }
        }

        impl std::fmt::Display for $name {
            fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
                f.write_str($crate::model::json::words::Words::word(*self))
            }
        }

        impl serde::Serialize for $name {
            fn serialize<S: serde::Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
                serializer.serialize_str($crate::model::json::words::Words::word(*self))
            }
        }

        impl<'de> serde::Deserialize<'de> for $name {
            fn deserialize<D: serde::Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
                struct Word;
                impl serde::de::Visitor<'_> for Word {
                    type Value = $name;
                    fn expecting(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
                        write!(f, "`{}`", <$name as $crate::model::json::words::Words>::WORDS.join("`, `"))
                    }
                    fn visit_str<E: serde::de::Error>(self, word: &str) -> Result<$name, E> {
                        <$name as $crate::model::json::words::Words>::from_word(word).ok_or_else(|| E::unknown_variant(word, <$name as $crate::model::json::words::Words>::WORDS))
                    }
                }
                deserializer.deserialize_str(Word)
            }
        }
    };
}

pub(crate) use words;
