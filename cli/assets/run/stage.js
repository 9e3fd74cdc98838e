// The structure in motion on a canvas: rods, pins, supports, loads, probes, axes.

// Fields that colour the rods.
const FIELDS = [
  { key: "temperature", label: "temperature change", unit: "K" },
  { key: "elastic", label: "elastic axial strain", unit: "" },
  { key: "strain", label: "axial strain with heat", unit: "" },
  { key: "curvature", label: "curvature", unit: "1/m" },
];

// A factor over time: pairs [t, value], linear in between, constant outside.
function historyAt(history, t) {
  return valueAt(history.map((pair) => pair[0]), history.map((pair) => pair[1]), t);
}

// Least and most of what `read` finds at all points of all frames.
function extent(values) {
  let [least, most] = [0, 0];
  for (const value of values) {
    if (value < least) least = value;
    if (value > most) most = value;
  }
  return [least, most];
}

// The motion as the page reads it: rods with their undeformed axes and with numbers in SI units.
function makeModel(data) {
  const { scene } = data.summary;
  const { motion } = data;
  const rods = scene.rods.map((rod, n) => {
    const own = motion.rods[n];
    const [from, to] = [scene.points[rod.from], scene.points[rod.to]];
    const along = [to[0] - from[0], to[1] - from[1]];
    const numbers = (list, quantum) => Float64Array.from(list, (value) => value * quantum);
    return {
      name: rod.name, ends: [rod.from, rod.to], pivot: rod.pivot, count: own.at.length, at: own.at, height: own.height,
      from, along, length: Math.hypot(...along),
      u: numbers(own.x, motion.quantum), v: numbers(own.y, motion.quantum),
      strain: numbers(own.strain, motion.strain_quantum), elastic: numbers(own.elastic, motion.elastic_quantum),
      curvature: numbers(own.curvature, motion.curvature_quantum), temperature: own.temperature,
      x: new Float64Array(own.at.length), y: new Float64Array(own.at.length), value: new Float64Array(own.at.length),
    };
  });
  const places = {};
  for (const rod of rods) {
    places[rod.ends[0]] ??= [rod, 0];
    places[rod.ends[1]] ??= [rod, 1];
    if (rod.pivot) places[rod.pivot] ??= [rod, 0.5];
  }
  return { scene, t: motion.t, load: motion.load, rods, places };
}

// Frame before a time, and the share of the way to the next one.
function frameAt(times, t) {
  let [low, high] = [0, times.length - 1];
  if (high < 1 || !(t > times[0])) return [0, 0];
  if (t >= times[high]) return [high - 1, 1];
  while (high - low > 1) {
    const middle = (low + high) >> 1;
    if (times[middle] <= t) low = middle;
    else high = middle;
  }
  return [low, (t - times[low]) / (times[high] - times[low])];
}

// Puts the rods where they are at a time, with deflections from the chords or displacements from the start magnified.
function pose(model, t, basis, factor, field) {
  const [frame, share] = frameAt(model.t, t);
  for (const rod of model.rods) {
    const { count, at, from, along, x, y } = rod;
    const [now, next] = [frame * count, Math.min(frame + 1, model.t.length - 1) * count];
    const between = (list, k) => list[now + k] + share * (list[next + k] - list[now + k]);
    const scale = basis === "displacement" ? factor : 1;
    for (let k = 0; k < count; k++) {
      x[k] = from[0] + at[k] * along[0] + scale * between(rod.u, k);
      y[k] = from[1] + at[k] * along[1] + scale * between(rod.v, k);
    }
    if (basis === "deflection" && factor !== 1) {
      const [x0, y0, dx, dy] = [x[0], y[0], x[count - 1] - x[0], y[count - 1] - y[0]];
      for (let k = 1; k < count - 1; k++) {
        const [chordX, chordY] = [x0 + at[k] * dx, y0 + at[k] * dy];
        x[k] = chordX + factor * (x[k] - chordX);
        y[k] = chordY + factor * (y[k] - chordY);
      }
    }
    if (field === "temperature") {
      const [a, b] = [rod.temperature[frame], rod.temperature[Math.min(frame + 1, model.t.length - 1)]];
      rod.value.fill(a + share * (b - a));
    } else if (field) {
      for (let k = 0; k < count; k++) rod.value[k] = between(rod[field], k);
    }
  }
}

// Present position at a fraction of a rod.
function onRod(rod, fraction) {
  const place = fraction * (rod.count - 1);
  const k = Math.min(rod.count - 2, Math.floor(place));
  const share = place - k;
  return [rod.x[k] + share * (rod.x[k + 1] - rod.x[k]), rod.y[k] + share * (rod.y[k + 1] - rod.y[k])];
}

function extentOf(values) {
  return Math.max(...values) - Math.min(...values);
}

function makeStage(data, canvas) {
  const model = makeModel(data);
  const { scene, rods } = model;
  const pen = canvas.getContext("2d");
  const at = (point) => onRod(...model.places[point]);
  const state = { t: model.t[0] ?? 0, basis: "deflection", factor: 1, field: "", names: false, scale: null };
  const box = { left: 0, bottom: 0, zoom: 1, width: 0, height: 0 };
  let colours = {};
  let trails = [];
  const pins = Object.keys(model.places).filter((point) => rods.filter((rod) => rod.ends.includes(point) || rod.pivot === point).length > 1);
  const heat = rods.flatMap((rod) => rod.temperature);
  const strongest = Math.max(0, ...scene.forces?.map((force) => Math.hypot(...force.force)) ?? []);

  const screen = (x, y) => [box.left + x * box.zoom, box.bottom - y * box.zoom];

  // Room for the structure in all frames, with the present magnification; and the trails of probed points.
  function fit() {
    let [left, right, low, high] = [Infinity, -Infinity, Infinity, -Infinity];
    const reach = (x, y) => {
      [left, right, low, high] = [Math.min(left, x), Math.max(right, x), Math.min(low, y), Math.max(high, y)];
    };
    const probed = [...new Set((scene.probes ?? []).filter((probe) => probe.point).map((probe) => probe.point))];
    trails = probed.map(() => []);
    model.t.forEach((t) => {
      pose(model, t, state.basis, state.factor, "");
      rods.forEach((rod) => rod.x.forEach((x, k) => reach(x, rod.y[k])));
      probed.forEach((point, n) => trails[n].push(at(point)));
    });
    rods.forEach((rod) => [0, 1].forEach((end) => reach(rod.from[0] + end * rod.along[0], rod.from[1] + end * rod.along[1])));
    const width = canvas.clientWidth || 600;
    const [wide, tall] = [Math.max(right - left, 1e-9), Math.max(high - low, 1e-9)];
    const room = { left: width < 500 ? 70 : 88, right: width < 500 ? 26 : 62, top: 36, bottom: 56 };
    const inner = width - room.left - room.right;
    const height = Math.round(Math.max(230, Math.min(width < 500 ? 400 : 470, (tall * inner) / wide + room.top + room.bottom)));
    canvas.style.height = `${height}px`;
    const ratio = window.devicePixelRatio || 1;
    [canvas.width, canvas.height] = [Math.round(width * ratio), Math.round(height * ratio)];
    pen.setTransform(ratio, 0, 0, ratio, 0, 0);
    box.zoom = Math.min(inner / wide, (height - room.top - room.bottom) / tall);
    box.left = room.left + (inner - wide * box.zoom) / 2 - left * box.zoom;
    box.bottom = room.top + (height - room.top - room.bottom + tall * box.zoom) / 2 + low * box.zoom;
    Object.assign(box, { width, height, middle: [(left + right) / 2, (low + high) / 2], size: Math.hypot(wide, tall) });
    draw();
  }

  function restyle() {
    const names = ["--paper", "--ink", "--dim", "--grid", "--line", "--steel", "--ghost", "--edge", "--load", "--accent"];
    colours = Object.fromEntries(names.map((name) => [name.slice(2), theme(name)]));
    const range = ranges()[state.field];
    state.scale = range && colourScale(...range);
  }

  // Range of each field that is not zero everywhere.
  let known;
  function ranges() {
    known ??= Object.fromEntries(FIELDS.map(({ key }) => {
      const all = key === "temperature" ? [heat] : rods.map((rod) => rod[key]);
      const found = all.map(extent);
      return [key, [Math.min(0, ...found.map((own) => own[0])), Math.max(0, ...found.map((own) => own[1]))]];
    }).filter(([, [least, most]]) => most > least));
    return known;
  }

  function line(points, style, width, dash) {
    pen.beginPath();
    points.forEach(([x, y], n) => (n ? pen.lineTo(x, y) : pen.moveTo(x, y)));
    Object.assign(pen, { strokeStyle: style, lineWidth: width });
    pen.setLineDash(dash ?? []);
    pen.stroke();
    pen.setLineDash([]);
  }

  function label(words, x, y, align, style, halo = true) {
    Object.assign(pen, { font: "12px system-ui, sans-serif", textAlign: align, textBaseline: "middle", lineJoin: "round" });
    if (halo) {
      Object.assign(pen, { strokeStyle: colours.paper, lineWidth: 3.5 });
      pen.strokeText(words, x, y);
    }
    pen.fillStyle = style;
    pen.fillText(words, x, y);
  }

  function axes() {
    const { width, height, zoom } = box;
    const [left, right] = [(48 - box.left) / zoom, (width - box.left) / zoom];
    const [low, high] = [(box.bottom - (height - 26)) / zoom, box.bottom / zoom];
    const step = (found) => (found.length > 1 ? found[1] - found[0] : 1);
    const columns = ticks(left, right, Math.max(4, width / 90));
    const same = step(columns);
    const rows = [];
    for (let n = Math.ceil(low / same); n * same <= high; n++) rows.push(n * same);
    columns.forEach((tick) => {
      const [x] = screen(tick, 0);
      if (x > width - 16) return;
      line([[x, 0], [x, height - 24]], tick === 0 ? colours.line : colours.grid, 1);
      label(tickText(tick, same), x, height - 12, "center", colours.dim, false);
    });
    rows.forEach((tick) => {
      const [, y] = screen(0, tick);
      if (y < 14 || y > height - 30) return;
      line([[46, y], [width, y]], tick === 0 ? colours.line : colours.grid, 1);
      label(tickText(tick, same), 42, y, "right", colours.dim, false);
    });
    label("y / m", 42, 10, "right", colours.dim);
    label("x / m", width - 6, height - 34, "right", colours.dim);
  }

  function arrow([x, y], [dx, dy], style) {
    const length = Math.hypot(dx, dy);
    if (length < 3) return;
    const [ux, uy] = [dx / length, dy / length];
    const head = Math.min(9, length * 0.6);
    const tip = [x + dx, y + dy];
    line([[x, y], [tip[0] - 0.8 * head * ux, tip[1] - 0.8 * head * uy]], style, 2.4);
    pen.beginPath();
    pen.moveTo(...tip);
    pen.lineTo(tip[0] - head * ux - 0.5 * head * uy, tip[1] - head * uy + 0.5 * head * ux);
    pen.lineTo(tip[0] - head * ux + 0.5 * head * uy, tip[1] - head * uy - 0.5 * head * ux);
    pen.fillStyle = style;
    pen.fill();
  }

  // Ground with hatching, `away` from a point along the unit vector n of the screen.
  function ground([x, y], [nx, ny], away, half) {
    const [tx, ty] = [-ny, nx];
    const on = (s, d) => [x + s * tx + (away + d) * nx, y + s * ty + (away + d) * ny];
    line([on(-half, 0), on(half, 0)], colours.ink, 1.6);
    for (let s = -half; s < half; s += 5) line([on(s + 4, 0), on(s, 5)], colours.dim, 1);
  }

  function support({ point, fix, slide, clamp }) {
    const place = at(point);
    const here = screen(...place);
    if (clamp) {
      const rod = rods.find((known) => known.name === clamp);
      const sign = point === rod.ends[1] ? 1 : -1;
      const n = [(sign * rod.along[0]) / rod.length, (-sign * rod.along[1]) / rod.length];
      ground(here, n, 2, 15);
      return;
    }
    let held = [0, 1];
    let rolls = false;
    if (slide) {
      const size = Math.hypot(...slide);
      [held, rolls] = [[-slide[1] / size, slide[0] / size], true];
    } else if (fix.length === 1) {
      [held, rolls] = [fix[0] === "x" ? [1, 0] : [0, 1], true];
    }
    // The ground lies outside of the structure, below it if in doubt.
    const outwards = held[0] * (place[0] - box.middle[0]) + held[1] * (place[1] - box.middle[1]);
    const sign = outwards > 0.05 * box.size && rolls ? 1 : -1;
    const n = [sign * held[0], -sign * held[1]];
    const [tx, ty] = [-n[1], n[0]];
    const on = (s, d) => [here[0] + s * tx + d * n[0], here[1] + s * ty + d * n[1]];
    pen.beginPath();
    [on(0, 0), on(-8, 13), on(8, 13)].forEach(([x, y], k) => (k ? pen.lineTo(x, y) : pen.moveTo(x, y)));
    pen.closePath();
    Object.assign(pen, { fillStyle: colours.paper, strokeStyle: colours.ink, lineWidth: 1.6 });
    pen.fill();
    pen.stroke();
    if (rolls) {
      [-4.5, 4.5].forEach((s) => {
        pen.beginPath();
        pen.arc(...on(s, 16.5), 3, 0, 7);
        pen.stroke();
      });
    }
    ground(here, n, rolls ? 20.5 : 13, 13);
  }

  function dot([x, y], radius, fill, edge) {
    pen.beginPath();
    pen.arc(x, y, radius, 0, 7);
    Object.assign(pen, { fillStyle: fill, strokeStyle: edge, lineWidth: 1.5 });
    pen.fill();
    pen.stroke();
  }

  function load() {
    const [frame, share] = frameAt(model.t, state.t);
    if (!data.statics) return 1;
    const next = Math.min(frame + 1, model.load.length - 1);
    return model.load[frame] + share * (model.load[next] - model.load[frame]);
  }

  function forces() {
    const time = data.statics ? load() : state.t;
    for (const { point, force, history } of scene.forces ?? []) {
      const factor = history ? historyAt(history, time) : load();
      const size = Math.hypot(...force) * Math.abs(factor);
      const here = screen(...at(point));
      const reach = (52 * factor) / strongest;
      const vector = [force[0] * reach, -force[1] * reach];
      arrow(here, vector, colours.load);
      const { factor: by, unit } = unitFor("N", strongest);
      if (size > 0.02 * strongest) label(`${text(size * by, 3)} ${unit}`, here[0] + vector[0] + 8, here[1] + vector[1], "left", colours.load);
    }
    const weight = Math.hypot(...scene.gravity ?? [0, 0]);
    if (weight > 0) {
      const [gx, gy] = [scene.gravity[0] / weight, -scene.gravity[1] / weight];
      const middle = [box.width - 24, 34];
      arrow([middle[0] - 17 * gx, middle[1] - 17 * gy], [34 * gx, 34 * gy], colours.load);
      label(`g = ${text(weight, 3)} m/s²`, middle[0] - 16, 14, "right", colours.load);
    }
  }

  function draw() {
    pose(model, state.t, state.basis, state.factor, state.field);
    pen.clearRect(0, 0, box.width, box.height);
    axes();
    const magnified = state.factor !== 1;
    rods.forEach(({ from, along }) => line([screen(...from), screen(from[0] + along[0], from[1] + along[1])], colours.ghost, 1.2, [5, 4]));
    const [frame] = frameAt(model.t, state.t);
    trails.forEach((trail) => {
      const until = trail.slice(0, frame + 1).map(([x, y]) => screen(x, y));
      line(until, colours.accent, 1);
    });
    pen.lineCap = "round";
    rods.forEach((rod) => {
      const width = Math.max(4, Math.min(26, rod.height * box.zoom));
      const points = Array.from(rod.x, (x, k) => screen(x, rod.y[k]));
      line(points, colours.edge, width + 1.6);
      if (!state.scale) return line(points, colours.steel, width);
      for (let k = 0; k + 1 < points.length; k++) {
        line([points[k], points[k + 1]], state.scale.colour((rod.value[k] + rod.value[k + 1]) / 2), width);
      }
    });
    pen.lineCap = "butt";
    scene.supports?.forEach(support);
    pins.forEach((point) => dot(screen(...at(point)), 3.4, colours.paper, colours.ink));
    forces();
    const labels = [];
    for (const probe of scene.probes ?? []) {
      const here = screen(...(probe.point ? at(probe.point) : onRod(rods.find((rod) => rod.name === probe.rod), probe.at)));
      dot(here, 5, "transparent", colours.accent);
      const place = [here[0] + 9, here[1] - 9, pen.measureText(probe.name).width];
      // Of labels that would cover one another the first stays.
      const covers = ([x, y, width]) => Math.abs(y - place[1]) < 12 && x < place[0] + place[2] && place[0] < x + width;
      if (state.names || labels.some(covers)) continue;
      labels.push(place);
      label(probe.name, place[0], place[1], "left", colours.accent);
    }
    if (state.names) {
      Object.keys(model.places).forEach((point) => {
        const here = screen(...at(point));
        label(point, here[0] + 8, here[1] - 10, "left", colours.ink);
      });
      rods.forEach((rod) => {
        const here = screen(...onRod(rod, 0.35));
        label(rod.name, here[0] + 8, here[1], "left", colours.dim);
      });
    }
    if (magnified) label(`${state.basis}s ×${text(state.factor, 1)}`, 54, 14, "left", colours.ink);
  }

  // The point of a rod that is nearest to a place on the canvas.
  function near(x, y) {
    let best = { distance: 16 };
    rods.forEach((rod) => rod.x.forEach((own, k) => {
      const [px, py] = screen(own, rod.y[k]);
      const distance = Math.hypot(px - x, py - y);
      if (distance < best.distance) best = { distance, rod, at: rod.at[k], value: state.scale && rod.value[k] };
    }));
    return best.rod && best;
  }

  // Largest displacement from the start and largest deflection from a chord, m.
  function largest() {
    let [displacement, deflection] = [0, 0];
    model.t.forEach((t) => {
      pose(model, t, "deflection", 1, "");
      rods.forEach(({ x, y, at: fractions, count, from, along }) => x.forEach((own, k) => {
        displacement = Math.max(displacement, Math.hypot(own - from[0] - fractions[k] * along[0], y[k] - from[1] - fractions[k] * along[1]));
        const [cx, cy] = [x[0] + fractions[k] * (x[count - 1] - x[0]), y[0] + fractions[k] * (y[count - 1] - y[0])];
        deflection = Math.max(deflection, Math.hypot(own - cx, y[k] - cy));
      }));
    });
    const span = (axis) => extentOf(Object.values(scene.points).map((point) => point[axis]));
    return { displacement, deflection, size: Math.hypot(span(0), span(1)) };
  }

  // Field that says most: heat, else what strains the rods' surfaces more, bending or stretching.
  function telling() {
    const own = ranges();
    if (own.temperature) return "temperature";
    const bending = Math.max(...rods.map((rod) => (rod.height / 2) * Math.max(...extent(rod.curvature).map(Math.abs))));
    const stretching = Math.max(...rods.map((rod) => Math.max(...extent(rod.elastic).map(Math.abs))));
    return bending > stretching ? "curvature" : "elastic";
  }

  restyle();
  return { model, state, draw, fit, restyle, ranges, telling, near, largest, load, screen, at };
}
