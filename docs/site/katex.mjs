// Typesets formulas: a line of JSON {"tex", "display"} in, a line of JSON {"html"} or {"error"} out. The argument is the folder of KaTeX.
import { createInterface } from "node:readline";
import { pathToFileURL } from "node:url";
import { resolve } from "node:path";

const { default: katex } = await import(pathToFileURL(resolve(process.argv[2], "dist/katex.mjs")));

for await (const line of createInterface({ input: process.stdin })) {
  const { tex, display } = JSON.parse(line);
  let answer;
  try {
    answer = { html: katex.renderToString(tex, { displayMode: display, throwOnError: true, strict: "error" }) };
  } catch (error) {
    answer = { error: error.message };
  }
  process.stdout.write(JSON.stringify(answer) + "\n");
}
