(* The extracted checker, with zarith's fractions in front: both are a numerator and a positive
   denominator. Trusted: the functions [..._holds] and [volume] hand over what they are given. *)

type point = Q.t * Q.t
type stretch = Checker.stretch
type token = Checker.token
type node = Checker.node
type witness = Checker.witness

let fraction (q : Q.t) : Checker.q = { qnum = Q.num q; qden = Q.den q }
let vertex (x, y) : Checker.vertex = (fraction x, fraction y)
let vertices = List.map vertex

let sum_holds s p q polygons witness components outside holes stretches =
  let polygon (outer, holes) = (vertices outer, List.map vertices holes) in
  Checker.check_form (fraction s) (List.map vertices p) (List.map vertices q)
    (List.map polygon polygons) witness components outside holes stretches

let point_holds s p q x part other tiled_p tiled_q i j =
  Checker.check_point (fraction s) (List.map vertices p) (List.map vertices q) (vertex x)
    (vertex part) (vertex other) tiled_p tiled_q i j

(* Vertex i of sP plus vertex j of Q *)
type place = int option * int option

let sign_holds p q of_ from to_ sign =
  Checker.check_sign (fraction from) (fraction to_) (List.map vertices p) (List.map vertices q) of_
    sign

let orientation (a : place) (b : place) (c : place) = Checker.Orientation (a, b, c)
let concurrent (a : place) b c d e f = Checker.Concurrent (a, b, c, d, e, f)

let passage_holds s p q witness path contacts =
  Checker.check_passage (fraction s) (List.map vertices p) (List.map vertices q) witness
    (vertices path) contacts

let vertex3 (x, y, z) : Checker.vertex3 = ((fraction x, fraction y), fraction z)
let mesh (corners, faces) : Checker.mesh = (List.map vertex3 corners, faces)

let body_holds s p q r pairs means =
  let weights = List.map (fun (i, w) -> (i, fraction w)) in
  Checker.check_body (vertex3 s) (mesh p) (mesh q) (mesh r) pairs
    (List.map (List.map weights) means)

let volume m : Q.t =
  let found = Checker.volume (mesh m) in
  Q.make found.qnum found.qden

let piece corners = Checker.Piece (vertices corners)
let group hull members = Checker.Group (vertices hull, members)

let tiled root solids : Checker.tiled =
  { root; solids = List.map (fun (hull, leaves) -> (vertices hull, leaves)) solids }

let covered corners i j parts = (vertices corners, Checker.Covered (i, j, vertices parts))
let apart corners code = (vertices corners, Checker.Apart code)
let open_p = Checker.OpenP
let open_q = Checker.OpenQ
let normal n = Checker.Normal (vertex n)
let stretch left right corner : stretch = ((left, right), vertex corner)
let contact normals on_left on_right : Checker.contact = { normals; on_left; on_right }
let component size links rim : Checker.component =
  {
    size;
    links = List.map (fun (back, m) -> (back, vertex m)) links;
    rim = List.map (fun (ring, others) -> (vertices ring, others)) rim;
  }

let witness of_P of_Q box cells : witness = { of_P; of_Q; box = vertices box; cells }
