// Numbers as text, and as colours that everybody can tell apart: blue below zero, orange above.

const SUPERSCRIPTS = { "-": "⁻", 0: "⁰", 1: "¹", 2: "²", 3: "³", 4: "⁴", 5: "⁵", 6: "⁶", 7: "⁷", 8: "⁸", 9: "⁹" };
const PREFIXES = { "-9": "n", "-6": "µ", "-3": "m", 0: "", 3: "k", 6: "M", 9: "G" };

function power(exponent) {
  return "10" + [...String(exponent)].map((character) => SUPERSCRIPTS[character]).join("");
}

// A number with so many significant digits.
function text(value, digits = 4) {
  if (value === null || value === undefined || Number.isNaN(value)) return "–";
  if (value === 0) return "0";
  const size = Math.abs(value);
  if (size >= 1e-3 && size < 1e6) {
    const decimals = Math.max(0, digits - 1 - Math.floor(Math.log10(size)));
    return value.toFixed(Math.min(decimals, 12)).replace("-", "−");
  }
  const [mantissa, exponent] = value.toExponential(digits - 1).split("e");
  return `${mantissa.replace("-", "−")}·${power(Number(exponent))}`;
}

// A number without zeros at its end.
function short(value) {
  return String(Number(value.toPrecision(6))).replace("-", "−");
}

// The unit in which numbers up to `largest` have few digits before and behind the point, and the factor to it.
function unitFor(unit, largest) {
  if (!(largest > 0) || unit === "K") return { factor: 1, unit };
  const exponent = 3 * Math.floor((Math.log10(largest) + 1) / 3);
  if (unit === "") return exponent < 0 ? { factor: 10 ** -exponent, unit: `×${power(exponent)}` } : { factor: 1, unit };
  if (unit === "1/m") return { factor: 1, unit };
  if (exponent < -9) return { factor: 10 ** -exponent, unit: `${power(exponent)} ${unit}` };
  const nearest = Math.min(9, exponent);
  // A thousand metres are no kilometre here: only lengths below one are given a prefix.
  if (unit.startsWith("m") && nearest > 0) return { factor: 1, unit };
  return { factor: 10 ** -nearest, unit: PREFIXES[nearest] + unit };
}

// Round numbers within a range, about so many.
function ticks(least, most, count) {
  const raw = (most - least) / Math.max(1, count);
  if (!(raw > 0)) return [least];
  const size = 10 ** Math.floor(Math.log10(raw));
  const step = [1, 2, 5, 10].map((part) => part * size).find((part) => part >= raw * 0.999);
  const found = [];
  for (let n = Math.ceil(least / step - 1e-9); n * step <= most + 1e-9 * step; n++) found.push(n * step);
  return found;
}

// Text of a tick whose neighbours are `step` away.
function tickText(value, step) {
  const decimals = Math.max(0, Math.min(9, -Math.floor(Math.log10(step) + 1e-9)));
  const rounded = value.toFixed(decimals);
  return (Number(rounded) === 0 ? (0).toFixed(decimals) : rounded).replace("-", "−");
}

function theme(name) {
  return getComputedStyle(document.documentElement).getPropertyValue(name).trim();
}

function mix(from, to, share) {
  const parts = (colour) => [1, 3, 5].map((place) => parseInt(colour.slice(place, place + 2), 16));
  const [a, b] = [parts(from), parts(to)];
  return `rgb(${a.map((part, n) => Math.round(part + share * (b[n] - part))).join(" ")})`;
}

// Colours of the values from `least` to `most`; zero is the middle colour, or an end.
function colourScale(least, most) {
  const reach = Math.max(-least, most, 0);
  const [low, high] = [least < 0 ? -reach : 0, most > 0 ? reach : 0];
  const stops = ["--low-2", "--low-1", "--mid", "--high-1", "--high-2"].map(theme);
  const at = (share) => {
    const place = Math.max(0, Math.min(3.999, 4 * share));
    return mix(stops[Math.floor(place)], stops[Math.floor(place) + 1], place % 1);
  };
  const table = Array.from({ length: 257 }, (_, n) => at(n / 256));
  const place = (value) => (reach > 0 ? 0.5 + value / (2 * reach) : 0.5);
  return {
    low, high,
    colour: (value) => table[Math.max(0, Math.min(256, Math.round(256 * place(value))))],
    gradient: Array.from({ length: 9 }, (_, n) => at(place(low + (n / 8) * (high - low)))).join(", "),
  };
}
