(* Rings of points, and the order of the canonical form. Not trusted: the proved checker is given
   the rings that come of it, and says whether they are in that form. *)

open Failure

type point = Q.t * Q.t

let ( -- ) (a, b) (c, d) : point = (Q.sub a c, Q.sub b d)
let ( ++ ) (a, b) (c, d) : point = (Q.add a c, Q.add b d)
let cross (a, b) (c, d) = Q.sub (Q.mul a d) (Q.mul b c)
let turn a b c = Q.sign (cross (b -- a) (c -- a))
let compare_points (a, b) (c, d) = match Q.compare a c with 0 -> Q.compare b d | n -> n

let edges_of ring =
  let at = Array.of_list ring in
  let n = Array.length at in
  List.init n (fun i -> (at.(i), at.((i + 1) mod n)))

(* The vertices at which a ring turns *)
let straightened ring =
  let at = Array.of_list ring in
  let n = Array.length at in
  List.filteri (fun i _ -> n < 3 || turn at.((i + n - 1) mod n) at.(i) at.((i + 1) mod n) <> 0) ring

(* All points along a ring by their numbers, from its least vertex; and its vertices alone *)
type ring = { along : int list; vertices : point list }

let ring point numbers =
  let at = Array.of_list numbers in
  let n = Array.length at in
  require (n > 2) "a ring has too few vertices";
  let first = ref 0 in
  Array.iteri (fun i p -> if compare_points (point p) (point at.(!first)) < 0 then first := i) at;
  let along = List.init n (fun i -> at.((!first + i) mod n)) in
  let vertices = straightened (List.map point along) in
  require (List.length vertices > 2) "a ring has too few vertices";
  { along; vertices }

(* Polygons, each its outer ring and its holes, in canonical order *)
let in_order point polygons =
  let compare_rings a b = List.compare compare_points a.vertices b.vertices in
  let polygon numbers =
    match List.map (ring point) numbers with
    | outer :: holes -> outer :: List.sort compare_rings holes
    | [] -> fail Malformed "a polygon has no ring"
  in
  List.sort (List.compare compare_rings) (List.map polygon polygons)
