// The data of the page: part, obstacles and path, the bad polygons, the valid scales and their bounds.
const data = JSON.parse(element("data").textContent);
const [windowFirst, windowLast] = data.window.map(([, about]) => about);
const clampScale = (s) => Math.min(Math.max(s, windowFirst), windowLast);
const scaleAt = (share) => clampScale(windowFirst + share * (windowLast - windowFirst));
const shareOfScale = (s) => (s - windowFirst) / (windowLast - windowFirst);
