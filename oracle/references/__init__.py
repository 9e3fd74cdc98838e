"""Reference solutions of statics and vibration: closed forms, or numbers on which two methods agree."""
