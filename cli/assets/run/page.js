// The page: fills in what is known of the run, and plays it.
//
// `#t=0.5` at the end of the address opens the page at that time, at rest. Scripts and tests have `window.ancfRun`.

const data = JSON.parse(document.getElementById("data").textContent);
const { summary } = data;
const find = (id) => document.getElementById(id);
const stage = makeStage(data, find("stage"));
const times = stage.model.t;
const [begin, end] = [times[0] ?? 0, times[times.length - 1] ?? 0];
const isPath = data.statics && summary.scene.time.path === "arc-length";
const timeText = {
  unit: data.statics ? "" : "\u00a0s",
  of: (t) => {
    if (isPath) return `row ${Math.round(t)} · load ${stage.load().toFixed(3)}`;
    return data.statics ? `load factor ${t.toFixed(3)}` : `t = ${t.toFixed(decimals)} s`;
  },
};
const decimals = Math.max(2, Math.min(9, 3 - Math.floor(Math.log10((end - begin) || 1))));

function notices() {
  const add = (kind, word, words) => {
    const notice = element("p", undefined, find("notices"), `notice ${kind}`);
    element("b", word, notice);
    rich(notice, words);
  };
  if (summary.status === "failed") {
    const until = summary.last_good_time === null ? "" : `. What is shown is the run until ${data.statics ? "the load factor" : "t ="} ${short(summary.last_good_time)}${timeText.unit}.`;
    add("bad", "The run failed.", summary.error + until);
  }
  summary.warnings.forEach((warning) => add("warn", "Warning.", warning));
}

function facts() {
  const { scene, counts } = summary;
  const add = (value, words) => {
    const fact = element("span", undefined, find("facts"));
    element("b", value, fact);
    fact.append(` ${words}`);
    find("facts").append(" ");
  };
  const elements = scene.rods.reduce((sum, rod) => sum + (rod.elements ?? 8), 0);
  add(scene.rods.length, scene.rods.length === 1 ? "rod" : "rods");
  add(elements, elements === 1 ? "element" : "elements");
  add(summary.method, data.statics ? "" : "method");
  add(summary.steps, data.statics ? "load steps" : `steps up to ${short(summary.final.t ?? 0)} s`);
  add(counts.newton_iterations, "Newton iterations");
  find("foot").append(`${data.program} · run `, element("code", summary.run), " · data: ");
  find("foot").append(element("code", summary.status === "failed" ? "trajectory.partial.csv" : "trajectory.csv"), ", ", element("code", "summary.json"));
  if (data.rows_each > 1) find("foot").append(` · charts show the smallest and the largest of each ${data.rows_each} rows`);
}

function table(parent, head, rows) {
  const made = element("table", undefined, parent);
  const cells = (kind, row, into) => row.forEach(([content, className]) => rich(element(kind, undefined, into, className), content));
  cells("th", head, element("tr", undefined, element("thead", undefined, made)));
  const body = element("tbody", undefined, made);
  rows.forEach((row) => cells("td", row, element("tr", undefined, body)));
}

function tables() {
  const { accuracy, plan, scene } = summary;
  const units = Object.fromEntries(data.charts.flatMap((chart) => chart.lines.map((line) => [line.column, chart.unit])));
  const ends = Object.entries(summary.final.probes);
  if (ends.length) {
    table(find("end"), [["column"], ["value", "number"], ["unit"]], ends.map(([name, value]) => [[name], [text(value, 6), "number"], [units[name] ?? ""]]));
  } else find("end").remove();
  const errors = find("accuracy");
  if (accuracy.columns.length) {
    for (const [of, known] of [["step", accuracy.time], ["mesh", accuracy.space]]) {
      if (known.value !== undefined) element("p", `Error of the ${of}: ${text(known.value, 2)} ${known.unit} (${known.method}).`, errors);
    }
    if (accuracy.amplification) element("p", `A deviation of 10⁻⁸ of the structure's size grows by a factor of ${text(accuracy.amplification, 2)}.`, errors);
    const words = { sure: (digits) => `${digits} digit${digits === 1 ? "" : "s"}`, unsure: () => "no digit is sure", none: () => "does not converge" };
    const last = Object.fromEntries([...data.charts.flatMap((chart) => chart.lines.map((line) => [line.column, line.values.at(-1)])), ...ends]);
    const row = (column) => {
      const [total, end] = [column.time + column.space, last[column.column] ?? NaN];
      // Of the last value, as the terminal counts them.
      const digits = total > 0 ? Math.min(15, Math.max(0, Math.floor(Math.log10(Math.abs(end) / total)) || 0)) : 15;
      const sure = digits > 0 || column.convergence !== "sure" ? words[column.convergence](digits) : "no digit is sure";
      return [[column.column], [text(end, 3), "number"], [text(column.time, 2), "number"], [text(column.space, 2), "number"], [units[column.column] ?? ""], [sure]];
    };
    table(errors, [["column"], ["at the end", "number"], ["± step", "number"], ["± mesh", "number"], ["unit"], ["sure"]], accuracy.columns.map(row));
  } else {
    const hint = element("p", "Not estimated: ", errors);
    hint.append(element("code", "ancf run SCENE --estimate"), " runs the scene again with finer steps and elements, and tells how many digits of each column are sure.");
  }
  if (accuracy.energy.value !== undefined) element("p", `Largest energy imbalance ${text(accuracy.energy.value, 2)} J. A small one says nothing of the accuracy in time and space.`, errors);
  table(find("plan"), [["part"], [""], ["why"]], plan.map((part) => [[part.what], [part.computed ? "computed" : "left out", part.computed ? "" : "off"], [part.why]]));
  if (!scene.notes?.length) return find("notes").remove();
  const list = element("ul", undefined, find("notes"));
  scene.notes.forEach((note) => element("li", note, list));
}

// Motion.
let now = begin;
let playing = false;
let last;
let drawn = 0;
const charts = data.charts.filter(() => data.rows.length > 0).map((chart) => makeChart(chart, data.rows, timeText, (t) => seek(t), nudge));

function show() {
  stage.state.t = now;
  stage.draw();
  find("time").value = now;
  find("clock").textContent = timeText.of(now);
  charts.forEach((chart) => chart.show(now));
  drawn += 1;
}

// Told to a screen reader only while nothing moves.
function tell() {
  find("time").setAttribute("aria-valuetext", timeText.of(now));
  find("stage").setAttribute("aria-label", `The structure at ${timeText.of(now)}; rods coloured by ${find("field").selectedOptions[0]?.textContent}`);
  charts.forEach((chart) => chart.tell(now));
}

function seek(t) {
  now = Math.max(begin, Math.min(end, t));
  show();
  if (!playing) tell();
}

function nudge(frames) {
  pause();
  const [frame, share] = frameAt(times, now);
  const place = frame + share + frames;
  const target = frames > 0 ? Math.floor(place + 1e-6) : Math.ceil(place - 1e-6);
  seek(times[Math.max(0, Math.min(times.length - 1, target))]);
}

function button() {
  const [path, word] = playing ? ["M3 2.5h3.6v11H3zM9.4 2.5H13v11H9.4z", "Pause"] : ["M4 2.5v11l9-5.5z", "Play"];
  find("play").querySelector("path").setAttribute("d", path);
  find("play").querySelector("span").textContent = word;
}

function step(stamp) {
  if (!playing) return;
  const seconds = Math.min(0.1, (stamp - (last ?? stamp)) / 1000);
  last = stamp;
  now += (seconds * (end - begin)) / Number(find("speed").value);
  if (now >= end) {
    if (find("loop").checked) now = begin + ((now - end) % ((end - begin) || 1));
    else {
      now = end;
      pause();
    }
  }
  show();
  requestAnimationFrame(step);
}

function play() {
  if (playing || !(end > begin)) return;
  if (now >= end) now = begin;
  [playing, last] = [true, undefined];
  button();
  requestAnimationFrame(step);
}

function pause() {
  playing = false;
  button();
  tell();
}

function controls() {
  const slider = find("time");
  [slider.min, slider.max, slider.value] = [begin, end, begin];
  slider.addEventListener("input", () => {
    pause();
    seek(Number(slider.value));
  });
  find("play").addEventListener("click", () => (playing ? pause() : play()));
  const range = end - begin;
  const real = !data.statics && range >= 1 && range <= 30;
  const speeds = real
    ? [[4, "¼ ×"], [2, "½ ×"], [1, "real time"], [0.5, "2 ×"], [0.25, "4 ×"]].map(([factor, words]) => [range * factor, words])
    : [32, 16, 8, 4, 2].map((seconds) => [seconds, `${seconds} s for the run`]);
  speeds.forEach(([seconds, words]) => Object.assign(element("option", words, find("speed")), { value: seconds }));
  find("speed").selectedIndex = 2;

  const fields = FIELDS.filter(({ key }) => key in stage.ranges());
  fields.forEach(({ key, label }) => Object.assign(element("option", label, find("field")), { value: key }));
  Object.assign(element("option", "none", find("field")), { value: "" });
  find("field").value = stage.telling() in stage.ranges() ? stage.telling() : "";
  find("field").addEventListener("change", recolour);

  const { displacement, deflection, size } = stage.largest();
  const largest = { displacement, deflection };
  const factors = { displacement: [], deflection: [] };
  for (const basis of ["deflection", "displacement"]) {
    for (let n = 0; n <= 24; n++) {
      const factor = [1, 2, 5][n % 3] * 10 ** Math.floor(n / 3);
      if (n === 0 || factor * largest[basis] <= 0.3 * size) factors[basis].push(factor);
    }
  }
  const magnify = () => {
    const { value } = find("basis");
    find("magnify").max = factors[value].length - 1;
    const factor = factors[value][Number(find("magnify").value)];
    find("factor").textContent = factor < 1e4 ? `×${factor}` : `×${text(factor, 1)}`;
    find("magnify").setAttribute("aria-valuetext", `${factor} times`);
    Object.assign(stage.state, { basis: value, factor });
    stage.fit();
  };
  // A motion too small to be seen is magnified from the start, and the picture says so.
  if (displacement > 0 && displacement < 0.02 * size) {
    find("basis").value = "displacement";
    find("magnify").max = factors.displacement.length - 1;
    find("magnify").value = factors.displacement.filter((factor) => factor * displacement <= 0.12 * size).length - 1;
  }
  find("basis").addEventListener("change", magnify);
  find("magnify").addEventListener("input", magnify);
  find("names").addEventListener("change", () => {
    stage.state.names = find("names").checked;
    stage.draw();
  });
  find("stage").addEventListener("pointermove", (event) => {
    const box = find("stage").getBoundingClientRect();
    const near = stage.near(event.clientX - box.left, event.clientY - box.top);
    const field = FIELDS.find(({ key }) => key === stage.state.field);
    find("here").textContent = near
      ? `${near.rod.name} at ${text(near.at, 3)} of its length${field && near.value !== null ? `: ${field.label} ${text(near.value, 4)} ${field.unit}` : ""}`
      : HINT;
  });
  document.addEventListener("keydown", (event) => {
    if (event.altKey || event.ctrlKey || event.metaKey || event.target.closest("select, button, input")) return;
    const keys = { " ": () => (playing ? pause() : play()), ArrowLeft: () => nudge(-1), ArrowRight: () => nudge(1), Home: () => nudge(-Infinity), End: () => nudge(Infinity) };
    if (!(event.key in keys)) return;
    event.preventDefault();
    keys[event.key]();
  });
  magnify();
}

const HINT = "Space plays and pauses, ← → go frame by frame. Point at a rod for its value, at a chart for its time.";

function recolour() {
  stage.state.field = find("field").value;
  stage.restyle();
  const field = FIELDS.find(({ key }) => key === stage.state.field);
  find("legend").hidden = !field;
  if (field) {
    const { low, high, gradient } = stage.state.scale;
    const { factor, unit } = unitFor(field.unit, Math.max(-low, high));
    find("ramp").style.background = `linear-gradient(to right, ${gradient})`;
    find("ticks").replaceChildren();
    const marks = low < 0 && high > 0 ? [low, 0, high] : [low, (low + high) / 2, high];
    marks.forEach((mark, n) => element("span", text(mark * factor, 3) + (n === 2 && unit ? `\u00a0${unit}` : ""), find("ticks")));
  }
  stage.draw();
  if (!playing) tell();
}

notices();
facts();
tables();
if (times.length) {
  controls();
  recolour();
  charts.forEach((chart) => find("charts").append(chart.figure));
  const resize = () => {
    stage.fit();
    charts.forEach((chart) => chart.draw());
    show();
  };
  // The height follows from the width, and would call the observer again.
  let width = 0;
  new ResizeObserver(() => {
    if (find("player").clientWidth === width) return;
    width = find("player").clientWidth;
    resize();
  }).observe(find("player"));
  resize();
  matchMedia("(prefers-color-scheme: dark)").addEventListener("change", recolour);
  find("here").textContent = HINT;
  const asked = /[#&]t=([-+.\deE]+)/.exec(location.hash);
  if (asked) seek(Number(asked[1]));
  else if (matchMedia("(prefers-reduced-motion: reduce)").matches) seek(begin);
  else play();
} else find("player").remove();

window.ancfRun = {
  seek, play, pause,
  get time() { return now; },
  get drawn() { return drawn; },
  get isPlaying() { return playing; },
  // Pixel of a point of the scene on the canvas.
  screen: (point) => stage.screen(...stage.at(point)),
  // Position of a point of the scene as drawn, m.
  position: (point) => stage.at(point),
};
performance.mark("shown");
