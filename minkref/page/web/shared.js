// Shared by the pages in the plane and in space: elements, counts in words, and the tip at the mouse.
const element = (id) => document.getElementById(id);
const counted = (count) => count.toLocaleString("en");
const several = (count, one, many = `${one}s`) => `${counted(count)} ${count === 1 ? one : many}`;

function tip(text, event) {
  const box = element("tip");
  box.hidden = !text;
  if (!text) return;
  box.textContent = text;
  const { width, height } = box.getBoundingClientRect();
  box.style.left = `${Math.max(Math.min(event.clientX + 14, innerWidth - width - 6), 6)}px`;
  box.style.top = `${event.clientY + 18 + height > innerHeight ? event.clientY - height - 10 : event.clientY + 18}px`;
}

// Scrolls a box so far that an element in it is seen, below a heading that stays; never the page.
function revealIn(box, inner) {
  const outer = box.getBoundingClientRect(), own = inner.getBoundingClientRect();
  const heading = box.querySelector("thead")?.getBoundingClientRect().height ?? 0;
  if (own.top < outer.top + heading) box.scrollTop -= outer.top + heading - own.top;
  else if (own.bottom > outer.top + box.clientHeight) box.scrollTop += own.bottom - outer.top - box.clientHeight;
}
