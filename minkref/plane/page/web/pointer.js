// The picture under the mouse: it is dragged, zoomed by the wheel, and what `things` find in it is pointed at.
const holesAtPointer = {
  find: (x, y) => drawing.holeAt(x, y),
  tell: (id) => describe("h", id),
  take: (id) => choose("h", id),
};
const nothingAtPointer = { find: () => null };

function listenToPicture(things) {
  const canvas = drawing.canvas;
  const at = (event) => {
    const box = canvas.getBoundingClientRect();
    return [event.clientX - box.left, event.clientY - box.top];
  };
  let start = null, moved = false;
  canvas.addEventListener("pointerdown", (event) => {
    start = { at: at(event), view: { ...drawing.view } };
    moved = false;
    canvas.setPointerCapture(event.pointerId);
  });
  canvas.addEventListener("pointermove", (event) => {
    const [x, y] = at(event);
    if (start && event.buttons & 1) {
      const dx = x - start.at[0], dy = y - start.at[1];
      moved = moved || Math.hypot(dx, dy) > 3;
      if (!moved) return;
      element("follow").checked = false;
      drawing.view = { ...start.view, x: start.view.x - dx / start.view.unit, y: start.view.y + dy / start.view.unit };
      show();
      return;
    }
    const id = things.find(x, y);
    canvas.style.cursor = id === null ? "grab" : "pointer";
    tip(id === null ? "" : things.tell(id), event);
  });
  canvas.addEventListener("pointerup", (event) => {
    const id = moved ? null : things.find(...at(event));
    start = null;
    if (id !== null) things.take(id);
  });
  canvas.addEventListener("pointerleave", () => tip(""));
  canvas.addEventListener("wheel", (event) => {
    event.preventDefault();
    element("follow").checked = false;
    const [x, y] = at(event), factor = Math.exp(-event.deltaY * 0.0015), view = drawing.view;
    const dx = x - canvas.clientWidth / 2, dy = y - canvas.clientHeight / 2;
    drawing.view = {
      unit: view.unit * factor,
      x: view.x + (dx / view.unit) * (1 - 1 / factor),
      y: view.y - (dy / view.unit) * (1 - 1 / factor),
    };
    show();
  }, { passive: false });
}
