(* The extracted checker, with zarith's fractions in front. Trusted: the functions [..._holds] and
   [volume] hand over what they are given; types are closed, and numbers are of Coq's kinds. *)

open Failure

type rational = Q.t * Q.t
type ring = rational list
type corner = Checker.corner
type stretch = Checker.stretch
type token = Checker.token
type node = Checker.node
type tiled = Checker.tiled
type cell = Checker.corner list * Checker.proof
type component = Checker.component
type witness = Checker.witness
type derivation = Checker.derivation
type contact = Checker.contact
type difference = Checker.difference_of
type change = Checker.change
type predicate = Checker.predicate

(* Zarith has 1/0, 0/0 and -1/0: before them every comparison would say yes. *)
let fraction (q : Q.t) : Checker.q =
  require (Z.sign q.den > 0) "a number has no positive denominator";
  { qnum = q.num; qden = q.den }

let natural n =
  require (n >= 0) "a number of something is negative";
  n

let vertex (x, y) : Checker.vertex = (fraction x, fraction y)
let vertices = List.map vertex
let rings = List.map vertices
let polygon vertex (p : 'v Reading.polygon) =
  (List.map vertex p.outer, List.map (List.map vertex) p.holes)

let sum_holds s p q polygons derivation =
  Checker.check_form (fraction s) (rings p) (rings q)
    (List.map (polygon vertex) polygons)
    derivation

let point_holds s p q x part other tiled_p tiled_q i j =
  Checker.check_one_point (fraction s) (rings p) (rings q) (vertex x) (vertex part) (vertex other)
    tiled_p tiled_q (natural i) (natural j)

let outside_holds s p q x tiled_p tiled_q code =
  Checker.check_one_outside (fraction s) (rings p) (rings q) (vertex x) tiled_p tiled_q code

(* Vertex i of sP plus vertex j of Q *)
type place = int option * int option

let sign_holds p q of_ from to_ sign =
  Checker.check_sign (fraction from) (fraction to_) (rings p) (rings q) of_ sign

let place (i, j) : Checker.index = (Option.map natural i, Option.map natural j)
let orientation a b c = Checker.Orientation (place a, place b, place c)

let concurrent a b c d e f =
  Checker.Concurrent (place a, place b, place c, place d, place e, place f)


let passage_holds s p q derivation path contacts =
  let { Checker.region_of; _ } = derivation in
  Checker.check_one_passage (fraction s) (rings p) (rings q) region_of (vertices path) contacts

(* The state of a sum: polygons, touching points, and how many holes *)
type 'v state = { polygons : 'v Reading.polygon list; touching : 'v list; enclosed : int }

let state vertex { polygons; touching; enclosed } =
  ((List.map (polygon vertex) polygons, List.map vertex touching), natural enclosed)

let mover (m : Reading.mover) : Checker.mover =
  ((fraction m.x0, fraction m.x1), (fraction m.y0, fraction m.y1))

(* What moves between two scales: a derivation of the first `move`, and then in turn of the sum at
   each scale between and of the next `move` *)
type interval = {
  from : Q.t;
  upto : Q.t;
  figure : Reading.mover state;
  first : derivation;
  rest : (Q.t * derivation * derivation) list;
}

let part_of_event { figure; first; rest; _ } : Checker.part_of_event =
  {
    figure_there = state mover figure;
    first_move = first;
    more_moves = List.map (fun (s, there, next) -> ((fraction s, there), next)) rest;
  }

let interval_holds p q interval =
  let { Checker.figure_there; first_move; more_moves } = part_of_event interval in
  Checker.check_interval (fraction interval.from) (fraction interval.upto) (rings p) (rings q)
    figure_there first_move more_moves

let event_holds p q before s there derivation after change =
  Checker.check_event (fraction before.from) (fraction s) (fraction after.upto) (rings p) (rings q)
    (part_of_event before) (part_of_event after) (state vertex there) derivation change

let of_turn n = Checker.Of_turn (natural n)
let of_touching n = Checker.Of_touching (natural n)
let another_after found = Checker.Another_after found
let another_there found = Checker.Another_there found
let other_numbers = Checker.Other_numbers

let is_of_boundary = function
  | Checker.Another_after _ | Checker.Another_there _ -> true
  | Checker.Other_numbers -> false

let vertex3 (x, y, z) : Checker.vertex3 = ((fraction x, fraction y), fraction z)
let naturals = List.map natural

type mesh = (Q.t * Q.t * Q.t) list * int list list

let mesh (corners, faces) : Checker.mesh = (List.map vertex3 corners, List.map naturals faces)

let body_holds s p q r pairs =
  let pair (i, j) = (natural i, natural j) in
  Checker.check_body (vertex3 s) (mesh p) (mesh q) (mesh r) (List.map pair pairs)

let volume m : Q.t =
  let found = Checker.volume (mesh m) in
  Q.make found.qnum found.qden

(* A corner at one scale, or at both ends of a `move` *)
let corner places : corner =
  match List.split places with
  | [ x ], [ y ] -> (Checker.Fixed (fraction x), Checker.Fixed (fraction y))
  | xs, ys -> (Checker.Moving (List.map fraction xs), Checker.Moving (List.map fraction ys))

let fixed v = corner [ v ]
let origin = fixed (Q.zero, Q.zero)
let piece corners = Checker.Piece corners
let group hull members = Checker.Group (hull, members)

let tiled root solids : tiled =
  { root; solids = List.map (fun (hull, leaves) -> (hull, naturals leaves)) solids }

let covered corners i j parts = (corners, Checker.Covered (natural i, natural j, parts))
let apart corners code = (corners, Checker.Apart code)
let open_p = Checker.OpenP
let open_q = Checker.OpenQ
let normal n = Checker.Normal (fixed n)
let stretch left right corner : stretch = ((natural left, natural right), corner)

let contact normals on_left on_right : contact =
  { normals; on_left = natural on_left; on_right = natural on_right }

(* Whether a code separates points from the sum *)
let is_apart corners code (p : tiled) (q : tiled) =
  Checker.follow code corners [ (p.root, q.root) ]

let component size links rim : component =
  {
    size = natural size;
    links = List.map (fun (back, m) -> (natural back, m)) links;
    rim = List.map (fun (ring, others) -> (ring, naturals others)) rim;
  }

let witness of_P of_Q box cells : witness = { of_P; of_Q; box; cells }

let derivation region_of components_of outside_of holes_of rows_of : derivation =
  { region_of; components_of; outside_of; holes_of; rows_of }

let holes_in { Checker.holes_of; _ } = List.length holes_of
let shown derivation = derivation
let pieces_shown pieces = pieces
let code_shown code = code
