"use strict";
// What the page does with its data: live from the event stream, or frame by frame out of a log. It only asks;
// nothing that is clicked here reaches the vehicle.

const TRAIL_S = 30;
const LIVE_TOPICS = ["vehicle", "scan", "image", "tracks", "global_tracks", "elements", "sensor", "clutter", "truth", "ospa", "status"];
const FRAMES_A_SECOND = 10;   // While a log plays, at most.
const DECISIONS_MS = 1000;    // Between two looks at what was decided about the chosen track.
const HALF_A_MILLISECOND = 0.0005;   // To which the times of decisions are rounded [s].
const STALE_MS = 5000;        // Without a word from the server.
const MAX_OSPA = 300;

const $ = (id) => document.getElementById(id);
const map = new SonarMap($("map"));
const picture = {};           // The newest of each topic.
const trails = new Map();     // Of each track: [time, north, east, existence].
const ospaHistory = [];
const state = {mode: "live", paused: false, chosen: null, frames: 0, frame: 0, playing: false, heard: 0, events: 0, drawn: 0};
const decisions = {lines: [], without: false};   // About the chosen track.
let dirty = true;
window.lookout = {picture, trails, state, map};

function text(id, value) { const node = $(id); if (node.textContent !== value) node.textContent = value; }
function number(value, digits) { return Number.isFinite(value) ? value.toFixed(digits) : "-"; }

// --- taking data in -------------------------------------------------------------------------------------------

function take(topic, value) {
  picture[topic] = value;
  dirty = true;
  if (!value) return;
  if (topic === "scan") map.addScan(value);
  if (topic === "image") { map.addImage(value); addToWaterfall(value); }
  if (topic === "tracks") addToTrails(value);
  if (topic === "ospa") { ospaHistory.push(value); while (ospaHistory.length > MAX_OSPA) ospaHistory.shift(); }
}

function addToTrails(list) {
  const now = list.utime * 1e-6;
  for (const track of list.tracks) {
    const trail = trails.get(track.id) || [];
    if (trail.length && now < trail[trail.length - 1][0]) trail.length = 0;   // A clock that went back.
    const before = trail.length > 1 ? trail[trail.length - 2][0] : -Infinity;
    if (now - before < 0.45) trail.pop();   // The newest point replaces one that is as good as it.
    trail.push([now, track.north, track.east, track.existence]);
    trails.set(track.id, trail);
  }
  for (const [id, trail] of trails) {
    while (trail.length && (now - trail[0][0] > TRAIL_S || trail[0][0] > now)) trail.shift();
    if (!trail.length) trails.delete(id);
  }
}

function setTrails(all) {
  trails.clear();
  for (const id of Object.keys(all)) trails.set(Number(id), all[id]);
  dirty = true;
}

function bytesOf(base64) {
  const raw = atob(base64), bytes = new Uint8Array(raw.length);
  for (let i = 0; i < raw.length; i++) bytes[i] = raw.charCodeAt(i);
  return bytes;
}

// One column a ping: the strongest cell of all beams by range, near ranges below.
function addToWaterfall(image) {
  const canvas = $("waterfall"), context = canvas.getContext("2d");
  canvas.hidden = false;
  context.drawImage(canvas, -1, 0);
  const pixels = bytesOf(image.pixels), column = context.createImageData(1, canvas.height);
  for (let y = 0; y < canvas.height; y++) {
    const bin = Math.min(image.bins - 1, Math.floor((canvas.height - 1 - y) / canvas.height * image.bins));
    let strongest = 0;
    for (let beam = 0; beam < image.beams; beam++) strongest = Math.max(strongest, pixels[beam * image.bins + bin]);
    column.data.set([strongest, strongest * 0.85, strongest * 0.5, 255], 4 * y);
  }
  context.putImageData(column, canvas.width - 1, 0);
}

// --- showing it -----------------------------------------------------------------------------------------------

function cells(row, values) {
  while (row.cells.length < values.length) row.insertCell();
  values.forEach((value, i) => { if (row.cells[i].textContent !== value) row.cells[i].textContent = value; });
}

function fill(body, rows) {
  while (body.rows.length < rows.length) body.insertRow();
  while (body.rows.length > rows.length) body.deleteRow(-1);
  rows.forEach((values, i) => cells(body.rows[i], values));
}

const SHAPES = {confirmed: "\u25cf", tentative: "\u25b3", coasting: "\u25a1"};

function allTracks() {
  return [...(picture.tracks ? picture.tracks.tracks : []), ...(picture.global_tracks ? picture.global_tracks.tracks : [])];
}

function shownTracks() { return allTracks().filter((track) => map.isShown(track)); }

function course(track) {
  return (Math.atan2(track.velocity[1], track.velocity[0]) * 180 / Math.PI + 360) % 360;
}

function showTracks() {
  const tracks = shownTracks().sort((a, b) => b.existence - a.existence || a.id - b.id).slice(0, 100);
  const body = $("tracks");
  fill(body, tracks.map((track) => [SHAPES[track.status] || "?", String(track.id), number(track.north, 1), number(track.east, 1),
    number(Math.hypot(...track.velocity), 2), number(course(track), 0), number(track.existence, 2)]));
  tracks.forEach((track, i) => {
    body.rows[i].dataset.id = String(track.id);
    body.rows[i].title = track.status;
    body.rows[i].className = track.id === state.chosen ? "chosen" : "";
  });
}

function showSensor() {
  const sensor = picture.sensor;
  if (!sensor) return text("sensor", "not published");
  const pair = ([value, sigma], digits) => `${number(value, digits)} \u00b1 ${number(sigma, digits)}`;
  text("sensor", `P_M ${pair(sensor.miss, 3)}, P_F ${pair(sensor.false_alarm, 3)}, range sigma ${pair(sensor.range_sigma, 2)} m`);
}

function chart(canvas, series, top) {
  const context = canvas.getContext("2d"), {width, height} = canvas;
  context.clearRect(0, 0, width, height);
  for (const {points, colour} of series) {
    if (!points.length) continue;
    const first = points[0][0], span = Math.max(1e-9, points[points.length - 1][0] - first);
    context.strokeStyle = colour;
    context.lineWidth = 1.5;
    context.beginPath();
    points.forEach(([t, value], i) => {
      const x = (t - first) / span * (width - 2) + 1, y = height - 2 - Math.min(1, value / top) * (height - 4);
      if (i) context.lineTo(x, y); else context.moveTo(x, y);
    });
    context.stroke();
  }
}

function showOspa() {
  const ospa = picture.ospa;
  $("ospa-section").hidden = !ospa;
  if (!ospa) return;
  text("ospa", `${number(ospa.total, 2)} m (localization ${number(ospa.localization, 2)}, cardinality ${number(ospa.cardinality, 2)}), `
    + `${ospa.num_truth} targets, ${ospa.num_tracks} tracks`);
  const line = (name, colour) => ({colour, points: ospaHistory.map((report) => [report.utime, report[name]])});
  chart($("ospa-chart"), [line("total", "#ffffff"), line("cardinality", "#ff7f6e"), line("localization", "#5dade2")], ospa.cutoff);
}

function showStatus() {
  const status = picture.status;
  if (!status) return;
  fill($("nodes"), status.nodes.map((node) => [`${node.node} ${node.node_id}`, number(node.latency_ms[0], 2),
    number(node.latency_ms[1], 2), String(node.accepted), String(node.rejected), String(node.dropped)]));
  status.nodes.forEach((node, i) => { $("nodes").rows[i].title = node.last_error; });
  $("channels-section").hidden = !status.channels;
  const heard = (status.channels || []).filter((channel) => channel.received > 0);
  fill($("channels"), heard.map((channel) => [channel.name, number(channel.rate, 2), `${number(channel.age_s, 1)} s`,
    String(channel.lost), String(channel.bad)]));
}

function showHealth() {
  const light = $("light"), status = picture.status;
  let complaints = status && status.complaints ? status.complaints : [];
  let kind = "good", word = "healthy";
  if (state.mode === "log") { kind = "unknown"; word = "log"; complaints = []; }
  else if (!state.heard || Date.now() - state.heard > STALE_MS) { kind = "bad"; word = "no connection"; }
  else if (!status) { kind = "unknown"; word = "waiting"; }
  else if (complaints.length) { kind = "bad"; word = "not healthy"; }
  light.className = `light ${kind}`;
  text("light", `${kind === "good" ? "\u25cf" : kind === "bad" ? "\u25b2" : "\u25cb"} ${word}`);
  const list = $("complaints");
  while (list.children.length > complaints.length) list.lastChild.remove();
  while (list.children.length < complaints.length) list.append(document.createElement("li"));
  complaints.forEach((line, i) => { list.children[i].textContent = line; });
}

function showClutterButton() {
  const learnt = map.learntClutter(picture);
  $("clutter").classList.toggle("on", map.clutterShown(picture));
  $("clutter").title = learnt ? `where false returns are dense, as the tracker has learnt by ${number(learnt.utime * 1e-6, 1)} s`
    : "where returns came from in the last minute, counted by this page";
}

function showClock() {
  const newest = picture.tracks || picture.scan || picture.image || picture.vehicle;
  text("clock", newest ? `t = ${number(newest.utime * 1e-6, 2)} s${state.paused ? " (paused)" : ""}` : "");
}

function showChosen() {
  const section = $("chosen"), trail = trails.get(state.chosen);
  section.hidden = state.chosen === null;
  if (state.chosen === null) return;
  const track = allTracks().find((one) => one.id === state.chosen);
  showDecisions();
  text("chosen-title", `Track ${state.chosen}: ${track ? track.status : "gone"}`);
  if (!trail || !trail.length) return text("history-text", "no history in the last 30 s");
  chart($("history"), [{colour: "#58d68d", points: trail.map((point) => [point[0], point[3]])}], 1);
  const first = trail[0], last = trail[trail.length - 1];
  const way = Math.hypot(last[1] - first[1], last[2] - first[2]);
  const seen = track ? `, last detection ${number((picture.tracks ? picture.tracks.utime - track.last_detection_utime : 0) * 1e-6, 1)} s ago` : "";
  text("history-text", `${trail.length} points over ${number(last[0] - first[0], 1)} s, ${number(way, 1)} m from its place then`
    + `, existence ${number(first[3], 2)} \u2192 ${number(last[3], 2)}${seen}`);
}

function draw() {
  if (dirty) {
    dirty = false;
    map.draw(picture, trails, state.chosen);
    showTracks(); showSensor(); showOspa(); showStatus(); showHealth(); showChosen(); showClock(); showClutterButton();
    state.drawn++;
  }
  requestAnimationFrame(draw);
}

// --- what a person does ---------------------------------------------------------------------------------------

function choose(id) {
  state.chosen = id;
  dirty = true;
  decisions.lines = [];
  askDecisions();
}

// What the tracker decided about the chosen track, newest first, up to the time that is shown.
async function askDecisions() {
  const id = state.chosen;
  if (id === null || decisions.without) return;
  try {
    const answer = await fetch(`decisions?n=${id}`);
    decisions.without = answer.status === 404;
    const lines = answer.ok ? await answer.json() : [];
    if (state.chosen === id) decisions.lines = lines;
    dirty = true;
  } catch (error) {
    // The light says that there is no connection.
  }
}

function showDecisions() {
  const until = state.mode === "log" || state.paused ? newestUtime() * 1e-6 + HALF_A_MILLISECOND : Infinity;
  const shown = decisions.lines.filter((line) => !(line.time_s > until)).reverse();
  const list = $("decisions");
  while (list.children.length > shown.length) list.lastChild.remove();
  while (list.children.length < shown.length) list.append(document.createElement("li"));
  shown.forEach((line, i) => { if (list.children[i].textContent !== line.text) list.children[i].textContent = line.text; });
}

function toggle(id, change) {
  $(id).addEventListener("click", () => { $(id).classList.toggle("on", change()); dirty = true; });
}
toggle("orient", () => map.bowUp = !map.bowUp);
toggle("follow", () => map.follow = !map.follow);
toggle("clutter", () => map.showClutter = !map.clutterShown(picture));
toggle("tentative", () => map.showTentative = !map.showTentative);
toggle("truth", () => map.showTruth = !map.showTruth);

$("tracks").addEventListener("click", (event) => {
  const row = event.target.closest("tr");
  if (row) choose(Number(row.dataset.id));
});

let drag = null;
const fingers = new Map();    // Where each is on the map: two of them zoom.

function spread() {
  const [a, b] = [...fingers.values()];
  return Math.hypot(a.x - b.x, a.y - b.y);
}

function pinch(event) {
  const before = spread();
  fingers.set(event.pointerId, {x: event.offsetX, y: event.offsetY});
  if (before > 0) map.zoom(spread() / before);
  drag.moved = drag.pinched = dirty = true;
}

function release(event) {
  fingers.delete(event.pointerId);
  if (!fingers.size) drag = null;
}

$("map").addEventListener("pointerdown", (event) => {
  fingers.set(event.pointerId, {x: event.offsetX, y: event.offsetY});
  if (fingers.size === 1) drag = {x: event.offsetX, y: event.offsetY, moved: false};
});
$("map").addEventListener("pointermove", (event) => {
  if (!drag || !event.buttons) return;
  if (fingers.size === 2) return pinch(event);
  if (!drag.moved && Math.hypot(event.offsetX - drag.x, event.offsetY - drag.y) < 4) return;
  if (fingers.size > 2 || drag.pinched) return;
  drag.moved = true;
  map.follow = false;
  $("follow").classList.remove("on");
  map.moveBy(event.offsetX - drag.x, event.offsetY - drag.y);
  drag.x = event.offsetX; drag.y = event.offsetY;
  dirty = true;
});
$("map").addEventListener("pointerup", (event) => {
  if (drag && !drag.moved) choose(map.trackAt(shownTracks(), event.offsetX, event.offsetY));
  release(event);
});
$("map").addEventListener("pointercancel", release);
$("map").addEventListener("pointerleave", release);
$("map").addEventListener("wheel", (event) => {
  event.preventDefault();
  map.zoom(Math.exp(-event.deltaY * 0.0015));
  dirty = true;
}, {passive: false});
window.addEventListener("resize", () => { dirty = true; });

// --- live -----------------------------------------------------------------------------------------------------

function connect() {
  const stream = new EventSource("events");
  for (const topic of LIVE_TOPICS)
    stream.addEventListener(topic, (event) => {
      state.heard = Date.now();
      state.events++;
      if (!state.paused) take(topic, JSON.parse(event.data));
    });
  // The browser tries again by itself where a stream ends, but not after a refusal.
  stream.onerror = () => { if (stream.readyState === EventSource.CLOSED) setTimeout(connect, 2000); };
}

function startLive() {
  fetch("trails").then((answer) => answer.json()).then(setTrails).catch(() => {});
  connect();
  $("pause").addEventListener("click", () => {
    state.paused = !state.paused;
    text("pause", state.paused ? "Go on" : "Pause");
    $("pause").classList.toggle("on", state.paused);
    dirty = true;
  });
}

// --- a log ----------------------------------------------------------------------------------------------------

let wanted = null, busy = false, before = null;

// One request at a time, for the newest wish.
async function show(n) {
  wanted = n;
  if (busy) return;
  busy = true;
  try {
    while (wanted !== null) {
      const frame = wanted;
      wanted = null;
      await load(frame);
    }
  } catch (error) {
    text("frame", "no connection");
  } finally {
    busy = false;
  }
}

async function load(n) {
  const answer = await fetch(`frame?n=${n}`);
  if (!answer.ok) return;
  const topics = await answer.json();
  const jumped = n !== state.frame + 1;
  if (jumped) { map.scans = []; ospaHistory.length = 0; setTrails(await (await fetch(`trails?n=${n}`)).json()); }
  state.frame = n;
  for (const topic of LIVE_TOPICS) {
    const isNew = !before || JSON.stringify(before[topic]) !== JSON.stringify(topics[topic]);
    if (isNew) take(topic, topics[topic]);
  }
  before = topics;
  $("scrub").value = String(n);
  text("frame", `${n + 1} / ${state.frames}`);
}

function play(on) {
  state.playing = on;
  text("play", on ? "Pause" : "Play");
}

// In the time of the log: the next frame when as much time has passed as between the two.
async function playOn() {
  if (state.playing && !busy) {
    if (state.frame + 1 >= state.frames) play(false);
    else {
      const then = newestUtime();
      const begin = performance.now();
      await show(state.frame + 1);
      const gap = Math.min(2000, Math.max(0, (newestUtime() - then) * 1e-3));
      const spent = performance.now() - begin;
      return setTimeout(playOn, Math.max(1000 / (5 * FRAMES_A_SECOND), gap - spent));
    }
  }
  setTimeout(playOn, 1000 / FRAMES_A_SECOND);
}

function newestUtime() {
  const newest = picture.tracks || picture.scan || picture.image || picture.vehicle;
  return newest ? newest.utime : 0;
}

function startLog(mode) {
  state.frames = mode.frames;
  $("log").hidden = false;
  $("pause").hidden = true;
  $("scrub").max = String(mode.frames - 1);
  $("scrub").addEventListener("input", () => { play(false); show(Number($("scrub").value)); });
  $("play").addEventListener("click", () => {
    if (!state.playing && state.frame + 1 >= state.frames) show(0);
    play(!state.playing);
  });
  document.title = `Lookout: ${mode.name}`;
  state.frame = -1;
  show(0);
  playOn();
}

async function start() {
  try {
    const mode = await (await fetch("mode")).json();
    state.mode = mode.mode;
    if (mode.mode === "log") startLog(mode); else startLive();
  } catch (error) {
    setTimeout(start, 2000);
  }
}

setInterval(showHealth, 500);
setInterval(() => { if (state.mode === "live" && !state.paused) askDecisions(); }, DECISIONS_MS);
requestAnimationFrame(draw);
start();
