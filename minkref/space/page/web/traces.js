// @ts-check
// What plotly.js takes: columns of coordinates, and triangles.
/** @typedef {import("./data.js").Point} Point */
/** @typedef {Record<string, unknown>} Trace */
/** @typedef {{ points: Point[], i: number[], j: number[], k: number[] }} Mesh triangles by the numbers of points */

export const STAND_OFF = 0.0012;  // of vertices before the facets, in the unit of the picture

/** @param {(Point | null)[]} points */
export const columns = (points) => ({ x: points.map((p) => p?.[0] ?? null), y: points.map((p) => p?.[1] ?? null), z: points.map((p) => p?.[2] ?? null) });

/** @returns {Mesh} */
export const newMesh = () => ({ points: [], i: [], j: [], k: [] });

/** A convex polygon, its corners its own. @param {Mesh} mesh @param {Point[]} corners */
export function addFan(mesh, corners) {
  const first = mesh.points.length;
  mesh.points.push(...corners);
  for (let corner = 1; corner + 1 < corners.length; ++corner) {
    mesh.i.push(first);
    mesh.j.push(first + corner);
    mesh.k.push(first + corner + 1);
  }
}

/** In colours without light. @param {string} name @param {Mesh} mesh @returns {Trace} */
export const meshTrace = (name, { points, i, j, k }) => ({
  type: "mesh3d", name, ...columns(points), i, j, k, showscale: false,
  lighting: { ambient: 1, diffuse: 0, specular: 0, fresnel: 0, roughness: 1 },
});
