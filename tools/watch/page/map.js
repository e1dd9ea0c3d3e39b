"use strict";
// The map: what is drawn and where. Earth frame north-east in metres; the screen turns with the bow where asked.

const STATUS_COLOURS = {confirmed: "#58d68d", tentative: "#f7dc6f", coasting: "#85c1e9"};
const FADE_S = 8;         // Returns older than that are gone [s of data time].
const MAX_SCANS = 160;    // Of them kept, whatever their rate,
const MAX_RETURNS = 20000;   // and whatever they hold: as many as a phone draws 20 times a second.
const CLUTTER_BEAMS = 45, CLUTTER_BINS = 40;
const CLUTTER_MEMORY_S = 60;
const LEARNT_VALID_S = 60;        // A clutter map of the tracker that is older says nothing [s of data time].
const LEARNT_LEAST_DB = 6, LEARNT_MOST_DB = 25;   // Density over the background's where colour begins and is full.

class SonarMap {
  constructor(canvas) {
    this.canvas = canvas;
    this.context = canvas.getContext("2d");
    this.scale = 3;          // Pixels a metre.
    this.centre = {north: 0, east: 0};
    this.follow = true;
    this.bowUp = false;
    this.showClutter = null;   // Null: as soon as a tracker publishes what it has learnt.
    this.showTruth = true;
    this.showTentative = true;
    this.forget();
  }

  forget() {
    this.scans = [];
    this.clutter = new Float64Array(CLUTTER_BEAMS * CLUTTER_BINS);
    this.clutterTime = null;
    this.fan = null;
    this.framed = false;
  }

  addScan(scan) {
    const last = this.scans.length ? this.scans[this.scans.length - 1].utime : null;
    if (last !== null && scan.utime < last) this.forget();
    this.fan = {pose: scan.pose, edges: scan.edges, range: scan.max_range};
    const pose = scan.pose || {north: 0, east: 0, heading: 0};
    const points = [];
    for (let i = 0; i + 1 < scan.returns.length; i += 2) {
      const angle = pose.heading + scan.returns[i], range = scan.returns[i + 1];
      points.push(pose.north + range * Math.cos(angle), pose.east + range * Math.sin(angle));
    }
    this.scans.push({utime: scan.utime, points});
    let returns = this.scans.reduce((sum, one) => sum + one.points.length / 2, 0);
    while (this.scans.length > MAX_SCANS || scan.utime - this.scans[0].utime > FADE_S * 1e6
           || (returns > MAX_RETURNS && this.scans.length > 1))
      returns -= this.scans.shift().points.length / 2;
    this.learnClutter(scan);
    if (!this.framed) this.frame();
  }

  addImage(image) {
    if (!this.scans.length) {
      this.fan = {pose: image.pose, edges: image.edges, range: image.ranges[1]};
      if (!this.framed) this.frame();
    }
  }

  // Where returns came from in the last minute, in the sonar's own frame.
  learnClutter(scan) {
    const seconds = this.clutterTime === null ? 0 : (scan.utime - this.clutterTime) * 1e-6;
    this.clutterTime = scan.utime;
    const keep = Math.exp(-Math.max(0, seconds) / CLUTTER_MEMORY_S);
    for (let i = 0; i < this.clutter.length; i++) this.clutter[i] *= keep;
    const [first, last] = scan.edges;
    for (let i = 0; i + 1 < scan.returns.length; i += 2) {
      const beam = Math.floor((scan.returns[i] - first) / (last - first) * CLUTTER_BEAMS);
      const bin = Math.floor(scan.returns[i + 1] / scan.max_range * CLUTTER_BINS);
      if (beam >= 0 && beam < CLUTTER_BEAMS && bin >= 0 && bin < CLUTTER_BINS) this.clutter[beam * CLUTTER_BINS + bin]++;
    }
  }

  // The fan in the middle of the canvas, as large as it fits.
  frame() {
    const box = this.canvas.getBoundingClientRect();
    if (!this.fan || !box.width) return;
    this.scale = 0.9 * Math.min(box.width, box.height) / (1.25 * this.fan.range);
    this.framed = true;
  }

  turn() {
    const pose = this.fan && this.fan.pose;
    return this.bowUp && pose ? -pose.heading : 0;
  }

  toScreen(north, east) {
    const dn = north - this.centre.north, de = east - this.centre.east, turn = this.turn();
    const up = dn * Math.cos(turn) - de * Math.sin(turn), right = dn * Math.sin(turn) + de * Math.cos(turn);
    return [this.width / 2 + right * this.scale, this.height / 2 - up * this.scale];
  }

  moveBy(dx, dy) {
    const right = -dx / this.scale, up = dy / this.scale, turn = this.turn();
    this.centre.north += up * Math.cos(turn) + right * Math.sin(turn);
    this.centre.east += -up * Math.sin(turn) + right * Math.cos(turn);
  }

  zoom(factor) { this.scale = Math.min(200, Math.max(0.02, this.scale * factor)); }

  fit() {
    const box = this.canvas.getBoundingClientRect(), ratio = window.devicePixelRatio || 1;
    this.width = box.width;
    this.height = box.height;
    const width = Math.round(box.width * ratio), height = Math.round(box.height * ratio);
    if (this.canvas.width !== width || this.canvas.height !== height) {
      this.canvas.width = width;
      this.canvas.height = height;
    }
    this.context.setTransform(ratio, 0, 0, ratio, 0, 0);
  }

  draw(picture, trails, chosen) {
    this.fit();
    if (this.follow && this.fan) {
      const pose = this.fan.pose || {north: 0, east: 0, heading: 0};
      const middle = pose.heading + (this.fan.edges[0] + this.fan.edges[1]) / 2;
      this.centre = {north: pose.north + 0.5 * this.fan.range * Math.cos(middle),
                     east: pose.east + 0.5 * this.fan.range * Math.sin(middle)};
    }
    const context = this.context;
    context.clearRect(0, 0, this.width, this.height);
    this.drawFan();
    if (this.clutterShown(picture)) this.drawClutter(picture);
    this.drawReturns();
    if (this.showTruth && picture.truth) this.drawTruth(picture.truth.targets);
    if (picture.elements) this.drawElements(picture.elements.elements);
    for (const track of picture.global_tracks ? picture.global_tracks.tracks : []) this.drawTrack(track, null, false);
    for (const track of picture.tracks ? picture.tracks.tracks : [])
      if (this.isShown(track)) this.drawTrack(track, trails.get(track.id), track.id === chosen);
    this.drawVehicle(picture.vehicle);
    this.drawScale();
  }

  isShown(track) { return this.showTentative || track.status !== "tentative"; }

  path(points) {
    this.context.beginPath();
    points.forEach(([north, east], i) => {
      const [x, y] = this.toScreen(north, east);
      if (i) this.context.lineTo(x, y); else this.context.moveTo(x, y);
    });
  }

  sector(pose, first, last, near, far, steps) {
    const at = (range, angle) =>
      [pose.north + range * Math.cos(pose.heading + angle), pose.east + range * Math.sin(pose.heading + angle)];
    const points = [];
    for (let i = 0; i <= steps; i++) points.push(at(far, first + (last - first) * i / steps));
    for (let i = steps; i >= 0; i--) points.push(at(near, first + (last - first) * i / steps));
    return points;
  }

  drawFan() {
    if (!this.fan) return;
    const pose = this.fan.pose || {north: 0, east: 0, heading: 0};
    this.path(this.sector(pose, this.fan.edges[0], this.fan.edges[1], 0, this.fan.range, 48));
    this.context.fillStyle = "#12283a";
    this.context.fill();
    this.context.strokeStyle = "#2d5573";
    this.context.lineWidth = 1;
    this.context.stroke();
  }

  // What the tracker has learnt, while it holds.
  learntClutter(picture) {
    const map = picture.clutter, now = picture.tracks || picture.scan;
    return map && (!now || Math.abs(now.utime - map.utime) < LEARNT_VALID_S * 1e6) ? map : null;
  }

  clutterShown(picture) {
    return this.showClutter === null ? this.learntClutter(picture) !== null : this.showClutter;
  }

  drawClutter(picture) {
    const learnt = this.learntClutter(picture);
    if (learnt) this.drawLearntClutter(learnt); else this.drawCountedClutter();
  }

  // Its cells where the sonar was then: rocks stay where they are.
  drawLearntClutter(map) {
    for (let k = 0; k < map.density.length; k++) {
      const share = Math.min(1, (map.density[k] - LEARNT_LEAST_DB + 1) / (LEARNT_MOST_DB - LEARNT_LEAST_DB));
      if (share <= 0) continue;
      const left = map.first_bearing + Math.floor(k / map.num_ranges) * map.bearing_step, near = k % map.num_ranges * map.range_step;
      this.path(this.sector(map.pose, left, left + map.bearing_step, near, near + map.range_step, 1));
      this.context.fillStyle = `rgba(230,126,34,${(0.15 + 0.6 * share).toFixed(3)})`;
      this.context.fill();
    }
  }

  drawCountedClutter() {
    const pose = this.fan && this.fan.pose;
    const largest = this.clutter.reduce((a, b) => Math.max(a, b), 0);
    if (!pose || largest <= 0) return;
    const [first, last] = this.fan.edges, beam = (last - first) / CLUTTER_BEAMS, bin = this.fan.range / CLUTTER_BINS;
    for (let b = 0; b < CLUTTER_BEAMS; b++)
      for (let r = 0; r < CLUTTER_BINS; r++) {
        const share = this.clutter[b * CLUTTER_BINS + r] / largest;
        if (share < 0.02) continue;
        this.path(this.sector(pose, first + b * beam, first + (b + 1) * beam, r * bin, (r + 1) * bin, 1));
        this.context.fillStyle = `rgba(230,126,34,${(0.75 * share).toFixed(3)})`;
        this.context.fill();
      }
  }

  drawReturns() {
    if (!this.scans.length) return;
    const now = this.scans[this.scans.length - 1].utime;
    for (const scan of this.scans) {
      const age = (now - scan.utime) * 1e-6;
      this.context.fillStyle = `rgba(255,255,255,${(age === 0 ? 0.95 : 0.45 * (1 - age / FADE_S)).toFixed(3)})`;
      const size = age === 0 ? 3 : 2;
      for (let i = 0; i < scan.points.length; i += 2) {
        const [x, y] = this.toScreen(scan.points[i], scan.points[i + 1]);
        this.context.fillRect(x - size / 2, y - size / 2, size, size);
      }
    }
  }

  drawTruth(targets) {
    for (const target of targets) {
      const [x, y] = this.toScreen(target.north, target.east);
      this.context.strokeStyle = target.visible ? "#ff8fd6" : "#7d4a6b";
      this.context.lineWidth = 1.5;
      this.context.beginPath();
      this.context.moveTo(x - 6, y - 6); this.context.lineTo(x + 6, y + 6);
      this.context.moveTo(x - 6, y + 6); this.context.lineTo(x + 6, y - 6);
      this.context.stroke();
    }
  }

  drawElements(elements) {
    this.context.strokeStyle = "rgba(195,155,211,0.7)";
    this.context.lineWidth = 1;
    for (const element of elements) {
      const [x, y] = this.toScreen(element.north, element.east);
      this.context.strokeRect(x - 2.5, y - 2.5, 5, 5);
    }
  }

  drawTrack(track, trail, isChosen) {
    const context = this.context, [x, y] = this.toScreen(track.north, track.east);
    context.strokeStyle = context.fillStyle = STATUS_COLOURS[track.status] || "#ffffff";
    if (trail && trail.length > 1) {
      this.path(trail.map((point) => [point[1], point[2]]));
      context.globalAlpha = 0.6;
      context.lineWidth = isChosen ? 3 : 1.5;
      context.stroke();
      context.globalAlpha = 1;
    }
    this.drawEllipse(track);
    this.drawVelocity(track, x, y);
    context.lineWidth = isChosen ? 3 : 2;
    context.beginPath();
    if (track.status === "confirmed") context.arc(x, y, 5, 0, 2 * Math.PI);
    else if (track.status === "coasting") context.rect(x - 5, y - 5, 10, 10);
    else { context.moveTo(x, y - 6); context.lineTo(x + 6, y + 5); context.lineTo(x - 6, y + 5); context.closePath(); }
    if (track.status === "confirmed") context.fill(); else context.stroke();
    if (isChosen) { context.beginPath(); context.arc(x, y, 11, 0, 2 * Math.PI); context.strokeStyle = "#ffffff"; context.stroke(); }
    context.font = "bold 13px system-ui, sans-serif";
    context.fillText(String(track.id), x + 9, y - 7);
  }

  drawEllipse(track) {
    const [major, minor, heading] = track.ellipse;
    if (!(major > 0)) return;
    const points = [];
    for (let i = 0; i <= 40; i++) {
      const a = major * Math.cos(i * Math.PI / 20), b = minor * Math.sin(i * Math.PI / 20);
      points.push([track.north + a * Math.cos(heading) - b * Math.sin(heading),
                   track.east + a * Math.sin(heading) + b * Math.cos(heading)]);
    }
    this.path(points);
    this.context.lineWidth = 1;
    this.context.setLineDash(track.status === "tentative" ? [3, 3] : []);
    this.context.stroke();
    this.context.setLineDash([]);
  }

  drawVelocity(track, x, y) {
    const ahead = 10;  // Where it will be in so many seconds.
    const [tx, ty] = this.toScreen(track.north + ahead * track.velocity[0], track.east + ahead * track.velocity[1]);
    this.context.lineWidth = 1.5;
    this.context.beginPath();
    this.context.moveTo(x, y);
    this.context.lineTo(tx, ty);
    this.context.stroke();
  }

  drawVehicle(vehicle) {
    if (!vehicle) return;
    const [x, y] = this.toScreen(vehicle.north, vehicle.east), context = this.context;
    context.save();
    context.translate(x, y);
    context.rotate(vehicle.heading + this.turn());
    context.beginPath();
    context.moveTo(0, -10); context.lineTo(5, 7); context.lineTo(-5, 7); context.closePath();
    context.fillStyle = "#5dade2";
    context.fill();
    context.restore();
  }

  drawScale() {
    const wanted = 100 / this.scale, power = Math.pow(10, Math.floor(Math.log10(wanted)));
    const metres = [5, 2, 1].map((k) => k * power).find((k) => k <= wanted) || power;
    const context = this.context, y = this.height - 12;
    context.strokeStyle = context.fillStyle = "#8fa6b5";
    context.lineWidth = 2;
    context.beginPath();
    context.moveTo(12, y); context.lineTo(12 + metres * this.scale, y);
    context.stroke();
    context.font = "12px system-ui, sans-serif";
    context.fillText(`${metres} m`, 12, y - 5);
    const turn = this.turn();
    context.save();
    context.translate(this.width - 24, 26);
    context.rotate(turn);
    context.beginPath();
    context.moveTo(0, -14); context.lineTo(4, 8); context.lineTo(-4, 8); context.closePath();
    context.fill();
    context.restore();
    context.fillText("N", this.width - 28, 52);
  }

  // The track nearest to a click, within some pixels.
  trackAt(tracks, x, y) {
    let best = null, distance = 18;
    for (const track of tracks) {
      const [tx, ty] = this.toScreen(track.north, track.east), d = Math.hypot(tx - x, ty - y);
      if (d < distance) { best = track.id; distance = d; }
    }
    return best;
  }
}
