// A canvas as large as its element, in device pixels, and a view of the plane with y upwards.
function prepared(canvas) {
  const ratio = devicePixelRatio || 1;
  const width = Math.max(canvas.clientWidth, 1), height = Math.max(canvas.clientHeight, 1);
  if (canvas.width !== Math.round(width * ratio) || canvas.height !== Math.round(height * ratio)) {
    canvas.width = Math.round(width * ratio);
    canvas.height = Math.round(height * ratio);
  }
  const context = canvas.getContext("2d");
  context.setTransform(ratio, 0, 0, ratio, 0, 0);
  context.clearRect(0, 0, width, height);
  context.lineJoin = "round";
  return { context, width, height };
}

class Box {
  constructor() { this.xmin = this.ymin = Infinity; this.xmax = this.ymax = -Infinity; }
  add(x, y) {
    if (x < this.xmin) this.xmin = x;
    if (x > this.xmax) this.xmax = x;
    if (y < this.ymin) this.ymin = y;
    if (y > this.ymax) this.ymax = y;
  }
  get empty() { return this.xmin > this.xmax; }
  get across() { return this.empty ? 0 : this.xmax - this.xmin; }
  get up() { return this.empty ? 0 : this.ymax - this.ymin; }
  get x() { return this.empty ? 0 : (this.xmin + this.xmax) / 2; }
  get y() { return this.empty ? 0 : (this.ymin + this.ymax) / 2; }
}

// `unit`: pixels for a length of 1; (x, y) is in the middle.
function fitted(box, width, height, pad) {
  const across = (width - 2 * pad) / (box.across || 1e-300), up = (height - 2 * pad) / (box.up || 1e-300);
  const unit = Math.min(across, up);
  return { x: box.x, y: box.y, unit: unit > 1e290 || !(unit > 0) ? 1 : unit };
}

const toScreen = (view, width, height) => [
  (x) => width / 2 + (x - view.x) * view.unit,
  (y) => height / 2 - (y - view.y) * view.unit,
];

// Rings of numbers x, y, x, y, ... as a path; a factor for all of them.
function addRing(path, numbers, factor, X, Y) {
  for (let i = 0; i < numbers.length; i += 2) {
    const x = X(numbers[i] * factor), y = Y(numbers[i + 1] * factor);
    if (i) path.lineTo(x, y); else path.moveTo(x, y);
  }
  path.closePath();
}

// A line of a round length in the lower left corner.
function drawRuler(context, unit, height) {
  const most = 110 / unit, power = 10 ** Math.floor(Math.log10(most));
  const length = [5, 2, 1].map((n) => n * power).find((n) => n <= most);
  const y = height - 10;
  context.strokeStyle = context.fillStyle = colour("soft");
  context.lineWidth = 1.2;
  context.beginPath();
  context.moveTo(10, y - 4); context.lineTo(10, y); context.lineTo(10 + length * unit, y); context.lineTo(10 + length * unit, y - 4);
  context.stroke();
  context.font = "11px system-ui, 'DejaVu Sans', sans-serif";
  context.fillText(short(length), 14, y - 5);
}

// Tight passages: x, y, x, y, ... of each; lines, and a ring around a point.
function drawPassages(context, passages, X, Y) {
  context.strokeStyle = colour("tight");
  context.lineWidth = 2.6;
  context.beginPath();
  for (const numbers of passages) {
    for (let i = 0; i < numbers.length; i += 2) {
      const x = X(numbers[i]), y = Y(numbers[i + 1]);
      if (i) { context.lineTo(x, y); continue; }
      context.moveTo(x, y);
      if (numbers.length === 2) { context.moveTo(x + 5, y); context.arc(x, y, 5, 0, 2 * Math.PI); }
    }
  }
  context.stroke();
}
