(* Rings of points, and the order of the canonical form. Not trusted: the proved checker is given
   the rings that come of it, and says whether they are in that form. *)

open Failure

type point = Q.t * Q.t

let ( -- ) (a, b) (c, d) : point = (Q.sub a c, Q.sub b d)
let ( ++ ) (a, b) (c, d) : point = (Q.add a c, Q.add b d)
let times s (x, y) : point = (Q.mul s x, Q.mul s y)
let cross (a, b) (c, d) = Q.sub (Q.mul a d) (Q.mul b c)
let turn a b c = Q.sign (cross (b -- a) (c -- a))
let compare_points (a, b) (c, d) = match Q.compare a c with 0 -> Q.compare b d | n -> n

(* Where a point is at each scale of a step: at one, or at both ends. Between them no edge vanishes
   and no direction changes, so that what is decided in the middle holds for all. *)
type places = point list

let middle = function
  | [ p ] -> p
  | [ p; q ] -> times (Q.of_ints 1 2) (p ++ q)
  | _ -> invalid_arg "middle"

let edges_of ring =
  let at = Array.of_list ring in
  let n = Array.length at in
  List.init n (fun i -> (at.(i), at.((i + 1) mod n)))

(* Whether the way from a by b to c goes straight on *)
let goes_on a b c =
  let (u, v) as first = b -- a and (w, z) as next = c -- b in
  Q.equal (cross first next) Q.zero && Q.sign Q.((u * w) + (v * z)) > 0

(* The vertices of a ring but those where it goes straight on; [point] says where they are *)
let turning point ring =
  let at = Array.of_list (List.map point ring) in
  let n = Array.length at in
  let is_straight i = goes_on at.((i + n - 1) mod n) at.(i) at.((i + 1) mod n) in
  List.filteri (fun i _ -> n < 3 || not (is_straight i)) ring

let straightened ring = turning Fun.id ring

(* A ring from its first vertex of which something holds *)
let from is_first ring =
  let at = Array.of_list ring in
  let n = Array.length at in
  let rec first i =
    if i = n then fail Refuted "a ring is another" else if is_first at.(i) then i else first (i + 1)
  in
  let k = first 0 in
  List.init n (fun i -> at.((k + i) mod n))

let least compare = function
  | [] -> fail Malformed "a ring has too few vertices"
  | first :: rest -> List.fold_left (fun m v -> if compare v m < 0 then v else m) first rest

(* All points along a ring by their numbers, from its least vertex; and its vertices alone *)
type ring = { along : int list; turns : int list }

let started first { along; turns } =
  { along = from (( = ) first) along; turns = from (( = ) first) turns }

let ring point compare along =
  let turns = turning point along in
  require (List.length turns > 2) "a ring has too few vertices";
  started (least compare turns) { along; turns }

(* Polygons, each its outer ring and its holes, in canonical order: [compare] is that of vertices *)
let in_order point compare polygons =
  let compare_rings a b = List.compare compare a.turns b.turns in
  let polygon numbers =
    match List.map (ring point compare) numbers with
    | outer :: holes -> outer :: List.sort compare_rings holes
    | [] -> fail Malformed "a polygon has no ring"
  in
  List.sort (List.compare compare_rings) (List.map polygon polygons)
