// Charts over time, with a cursor that the structure follows.

const SVG = "http://www.w3.org/2000/svg";
const MARGIN = { left: 46, right: 10, top: 6, bottom: 20 };

function shape(name, attributes, parent) {
  const made = document.createElementNS(SVG, name);
  for (const [key, value] of Object.entries(attributes)) made.setAttribute(key, value);
  if (parent) parent.append(made);
  return made;
}

function element(name, content, parent, className) {
  const made = document.createElement(name);
  if (content !== undefined) made.textContent = content;
  if (className) made.className = className;
  if (parent) parent.append(made);
  return made;
}

// Value of a list over increasing times, linear in between.
function valueAt(times, values, t) {
  let [low, high] = [0, times.length - 1];
  if (!(t > times[0])) return values[0];
  if (t >= times[high]) return values[high];
  while (high - low > 1) {
    const middle = (low + high) >> 1;
    if (times[middle] <= t) low = middle;
    else high = middle;
  }
  const share = (t - times[low]) / (times[high] - times[low]);
  return values[low] + share * (values[high] - values[low]);
}

// Positions that change little beside where they are, as changes since the start.
function relative(chart) {
  const range = (values) => Math.max(...values) - Math.min(...values);
  const ownRange = Math.max(...chart.lines.map((line) => range(line.values)));
  if (chart.of !== "position" || ownRange === 0 || ownRange > 0.05 * range(chart.lines.flatMap((line) => line.values).concat(0))) return chart;
  const lines = chart.lines.map((line) => ({ ...line, values: line.values.map((value) => value - line.values[0]) }));
  return { ...chart, of: "displacement", lines };
}

// Text with what stands between backticks as code.
function rich(parent, words) {
  words.split("`").forEach((part, n) => parent.append(n % 2 ? element("code", part) : part));
}

// One chart; `seek` is called with the time that a person points at, `nudge` with the number of frames to go.
function makeChart(given, times, timeText, seek, nudge) {
  const chart = relative(given);
  const all = chart.lines.flatMap((line) => line.values);
  const [least, most] = all.reduce(([low, high], value) => [Math.min(low, value), Math.max(high, value)], [Infinity, -Infinity]);
  const { factor, unit } = unitFor(chart.unit, Math.max(-least, most));
  // A constant has a range as well; what is rounding alone is none.
  const pad = Math.max((most - least) * 0.06, 1e-9 * Math.max(-least, most), Number.MIN_VALUE);
  const [bottom, top] = most > least ? [least - pad, most + pad] : [least - (Math.abs(least) || 1), most + (Math.abs(most) || 1)];
  const figure = element("figure", undefined, undefined, "chart");
  const caption = element("figcaption", undefined, figure);
  const name = element("b", chart.name, caption);
  const mean = chart.mean ? `, mean over ${text(chart.mean, 2)} s` : "";
  if (chart.of || mean) name.append(` · ${chart.of}${mean}`);
  const values = element("span", undefined, caption, "values");
  const outputs = chart.lines.map((line, n) => {
    const entry = element("span", undefined, values);
    const label = element("i", chart.lines.length > 1 ? line.label + " " : "", entry);
    label.style.color = `var(--line-${n + 1})`;
    const output = element("output", "", entry);
    output.dataset.column = line.column;
    return output;
  });
  if (unit) element("span", unit, values);
  const svg = shape("svg", { tabindex: 0, role: "slider", "aria-label": `${chart.name} ${chart.of}: time`, "aria-valuemin": times[0], "aria-valuemax": times[times.length - 1] }, figure);
  const [begin, end] = [times[0], times[times.length - 1]];
  let inner = { left: MARGIN.left, width: 1 };
  let cursor, dots, at;

  function draw() {
    const { width, height } = svg.getBoundingClientRect();
    if (!width) return;
    svg.replaceChildren();
    svg.setAttribute("viewBox", `0 0 ${width} ${height}`);
    inner = { left: MARGIN.left, width: width - MARGIN.left - MARGIN.right };
    const lower = height - MARGIN.bottom;
    const x = (t) => inner.left + (inner.width * (t - begin)) / (end - begin || 1);
    const y = (value) => lower - ((lower - MARGIN.top) * (value - bottom)) / (top - bottom);
    const rows = ticks(bottom * factor, top * factor, 4);
    rows.forEach((tick) => {
      const place = y(tick / factor);
      shape("line", { class: tick === 0 ? "zero" : "grid", x1: inner.left, x2: width - MARGIN.right, y1: place, y2: place }, svg);
      const label = shape("text", { x: inner.left - 5, y: place + 4, "text-anchor": "end" }, svg);
      label.textContent = tickText(tick, rows.length > 1 ? rows[1] - rows[0] : 1);
    });
    const columns = ticks(begin, end, Math.max(2, Math.floor(inner.width / 70)));
    columns.forEach((tick, n) => {
      const label = shape("text", { x: x(tick), y: height - 5, "text-anchor": n === 0 && tick === begin ? "start" : x(tick) > width - 26 ? "end" : "middle" }, svg);
      label.textContent = tickText(tick, columns.length > 1 ? columns[1] - columns[0] : 1) + (n === columns.length - 1 ? timeText.unit : "");
    });
    chart.lines.forEach((line, n) => {
      const path = line.values.map((value, k) => `${k ? "L" : "M"}${x(times[k]).toFixed(1)} ${y(value).toFixed(1)}`).join("");
      shape("path", { class: "curve", d: path, stroke: `var(--line-${n + 1})` }, svg);
    });
    cursor = shape("line", { class: "cursor", y1: MARGIN.top, y2: lower }, svg);
    dots = chart.lines.map((_, n) => shape("circle", { r: 3.5, fill: `var(--line-${n + 1})`, stroke: "var(--paper)" }, svg));
    if (at !== undefined) show(at);

    function show(t) {
      at = t;
      const place = x(t);
      cursor.setAttribute("x1", place);
      cursor.setAttribute("x2", place);
      chart.lines.forEach((line, n) => {
        const value = valueAt(times, line.values, t);
        dots[n].setAttribute("cx", place);
        dots[n].setAttribute("cy", y(value));
        outputs[n].textContent = text(value * factor);
      });
    }
    figure.show = show;
  }

  function point(event) {
    const box = svg.getBoundingClientRect();
    const share = (event.clientX - box.left - inner.left) / inner.width;
    seek(begin + Math.max(0, Math.min(1, share)) * (end - begin));
  }
  svg.addEventListener("pointerdown", (event) => {
    svg.setPointerCapture(event.pointerId);
    point(event);
  });
  svg.addEventListener("pointermove", (event) => event.buttons && point(event));
  svg.addEventListener("keydown", (event) => {
    const steps = { ArrowLeft: -1, ArrowDown: -1, ArrowRight: 1, ArrowUp: 1, PageDown: -10, PageUp: 10, Home: -Infinity, End: Infinity };
    if (!(event.key in steps)) return;
    event.preventDefault();
    event.stopPropagation();
    nudge(steps[event.key]);
  });
  return {
    figure,
    draw,
    show: (t) => {
      at = t;
      if (figure.show) figure.show(t);
    },
    // Told to those who cannot see it when the motion rests.
    tell: (t) => {
      svg.setAttribute("aria-valuenow", t);
      const told = chart.lines.map((line, n) => `${line.label} ${outputs[n].textContent}`).join(", ");
      svg.setAttribute("aria-valuetext", `${timeText.of(t)}: ${told} ${unit}`);
    },
  };
}
