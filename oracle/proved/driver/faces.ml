(* Faces of convex polyhedra: what certificates must satisfy beyond what the theorem needs. *)

type point = Q.t * Q.t * Q.t

let ( -- ) (a, b, c) (d, e, f) : point = (Q.sub a d, Q.sub b e, Q.sub c f)

let cross (a, b, c) (d, e, f) : point =
  Q.((b * f) - (c * e), (c * d) - (a * f), (a * e) - (b * d))

let dot (a, b, c) (d, e, f) = Q.((a * d) + (b * e) + (c * f))

let area_vector ring =
  let add n (p, q) =
    let (a, b, c), (d, e, f) = (n, cross p q) in
    Q.(a + d, b + e, c + f)
  in
  List.fold_left add (Q.zero, Q.zero, Q.zero) (Rings.edges_of ring)

(* A point over one denominator: whole numbers *)
let over_one (a, b, c) =
  let d = Z.lcm Q.(den a) (Z.lcm Q.(den b) Q.(den c)) in
  let whole x = Z.divexact (Z.mul (Q.num x) d) (Q.den x) in
  (whole a, whole b, whole c, d)

(* The numbers of the points that are farthest along n *)
let farthest n points =
  let a, b, c, _ = over_one n in
  let levels = Array.map (fun (x, y, z, d) -> (Z.((a * x) + (b * y) + (c * z)), d)) points in
  let compare (k, d) (m, e) = Z.compare (Z.mul k e) (Z.mul m d) in
  let most = Array.fold_left (fun m l -> if compare l m > 0 then l else m) levels.(0) levels in
  List.filter (fun i -> compare levels.(i) most = 0) (List.init (Array.length levels) Fun.id)

(* Whether the faces in the plane of the first one add up to the hull of the vertices there. (The
   theorem needs no such thing.) *)
let goes_around_once vertices faces =
  let at = Array.of_list vertices in
  let ring face = List.map (fun i -> at.(i)) face in
  let normal face = area_vector (ring face) in
  match faces with
  | [] -> false
  | face :: _ ->
    let n = normal face and first = at.(List.hd face) in
    let flat (x, y, z) =
      let a, b, _ = n in
      if Q.sign a <> 0 then (y, z) else if Q.sign b <> 0 then (x, z) else (x, y)
    in
    let area points = Q.abs (Reading.doubled_area points) in
    let is_along k = Q.sign (dot n k) > 0 && dot (cross n k) (cross n k) = Q.zero in
    let covered =
      List.fold_left
        (fun sum face ->
          if is_along (normal face) then Q.add sum (area (List.map flat (ring face))) else sum)
        Q.zero faces
    in
    let top = List.filter (fun v -> Q.equal (dot n (v -- first)) Q.zero) vertices in
    let corners = Pieces.hull (List.map flat top) in
    Q.equal covered (area corners)
