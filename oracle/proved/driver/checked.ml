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
type code = Checker.step
type way = Checker.leg * code list
type hit = Checker.hit
type edge = (int * int) * Checker.edge_hit list
type trap = Checker.trapping
type path_claim = Checker.way_claim
type place_claim = Checker.trap_claim

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

type set = rational Reading.polygon list

let polygons = List.map (polygon vertex)
let is_legal p = Checker.decide_legal (polygons p)

let decide_points s p q points =
  Checker.decide_points (fraction s) (polygons p) (polygons q) (vertices points)

let with_holes =
  let rational (x : Checker.q) = Q.make x.qnum x.qden in
  let ring = List.map (fun (x, y) -> (rational x, rational y)) in
  let polygon (outer, holes) : _ Reading.polygon =
    { outer = ring outer; holes = List.map ring holes }
  in
  Option.map (fun (polygons, holes) -> (List.map polygon polygons, holes))

let verified_sum s p q =
  with_holes (Checker.verified_sum (fraction s) (polygons p) (polygons q))

type operation = Checker.operation = Unite | Intersect | Subtract

let is_polygon_set p = Checker.decide_polygon_set (polygons p)

let verified_combination operation p others =
  with_holes (Checker.verified_combination operation (polygons p) (List.map polygons others))

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

(* Paths and traps *)
let nodes (i, j) = (natural i, natural j)

let scales ({ low; high; low_in; high_in } : Reading.scales) : Checker.scales =
  { low = fraction low; high = Option.map fraction high; low_in; high_in }

let contact_of : Reading.contact -> Checker.touch = function
  | Allowed -> Allowed
  | Forbidden -> Forbidden

let moving_place (m : Reading.mover) = (fixed (m.x0, m.y0), fixed (m.x1, m.y1))
let open_part = Checker.OpenPart
let open_obstacles = Checker.OpenObstacles
let cut_at t = Checker.CutAt (fraction t)
let across n = Checker.Across (fixed n)
let nothing_left multiples = Checker.NothingLeft (List.map fraction multiples)
let constant q = Checker.Fixed (fraction q)

let way direction length growth code : way =
  ({ direction = fixed direction; length_ = constant length; growth = constant growth }, code)

let hit at segment (start, speed) shared_by point : hit =
  {
    hit_scales = scales at;
    segment = natural segment;
    along_start = constant start;
    along_speed = constant speed;
    nodes = nodes shared_by;
    shared = moving_place point;
  }

let edge shared_by hits : edge =
  let hit (at, first, last) : Checker.edge_hit =
    { edge_scales = scales at; at_start = moving_place first; at_end = moving_place last }
  in
  (nodes shared_by, List.map hit hits)

let trap some_scale ring edges here_free : trap =
  { some_scale = fraction some_scale; ring = List.map mover ring; edges; here_free }

type scene = { part : ring list; obstacles : ring list; path : ring; of_r : tiled; of_o : tiled }

let free_holds contact at { part; obstacles; path; of_r; of_o } ways =
  Checker.check_free (contact_of contact) (scales at) (rings part) (rings obstacles)
    (vertices path) of_r of_o ways

let hit_holds contact at { part; obstacles; path; of_r; of_o } hits =
  Checker.check_hit (contact_of contact) (scales at) (rings part) (rings obstacles)
    (vertices path) of_r of_o hits

let is_free ways = Checker.Is_free ways
let is_hit hits = Checker.Is_hit hits
let each_at claims = List.map (fun (at, claim) -> (scales at, claim)) claims

let valid_holds contact at found { part; obstacles; path; of_r; of_o } claims =
  Checker.check_valid (contact_of contact) (scales at) (List.map scales found) (rings part)
    (rings obstacles) (vertices path) of_r of_o (each_at claims)

let escapes_holds contact at scene places ways normal =
  match scene with
  | { part; obstacles; path = [ x ]; of_r; of_o } ->
    Checker.check_escapes (contact_of contact) (scales at) (rings part) (rings obstacles)
      (vertex x) of_r of_o (List.map moving_place places) ways (vertex normal)
  | _ -> false

let trapped_holds contact at scene trap =
  match scene with
  | { part; obstacles; path = [ x ]; of_r; of_o } ->
    Checker.check_trapped (contact_of contact) (scales at) (rings part) (rings obstacles)
      (vertex x) of_r of_o trap
  | _ -> false

let gets_away places ways normal =
  Checker.Gets_away (List.map moving_place places, ways, vertex normal)

let is_kept trap = Checker.Kept trap
let collides hits = Checker.Collides hits

let trap_holds contact at found scene claims =
  match scene with
  | { part; obstacles; path = [ x ]; of_r; of_o } ->
    Checker.check_trap (contact_of contact) (scales at) (List.map scales found) (rings part)
      (rings obstacles) (vertex x) of_r of_o (each_at claims)
  | _ -> false
