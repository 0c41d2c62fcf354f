// The field, buttons, keys and colours that pages with a slider share. Each page says what they do: `keys` by name,
// `enter` with the field, `redraw` names boxes that draw anew, `recolour` what colours change beside the layout.
function listenToControls({ keys, enter, previous, next, fit, redraw, recolour, layOut }) {
  for (const [id, go] of Object.entries({ previous, next, fit })) element(id).addEventListener("click", go);
  for (const id of redraw) element(id).addEventListener("change", show);
  const field = element("scale");
  field.addEventListener("change", () => enter(field));
  addEventListener("keydown", (event) => {
    if (event.target === field || event.ctrlKey || event.metaKey || event.altKey || !keys[event.key]) return;
    if (["barcode", "events"].includes(event.target.id) && event.key !== "Escape" && !event.key.startsWith("Arrow")) return;
    event.preventDefault();
    keys[event.key](event);
  });
  addEventListener("resize", layOut);
  matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () => {
    style = getComputedStyle(document.documentElement);
    recolour();
    layOut();
  });
}
