(* Each sum of two vertices as a mean of vertices of the sum, for the proved checker: of the first
   vertex and those of a triangle of a facet. Not trusted. *)

open Failure

type point = Q.t * Q.t * Q.t

let ( -- ) (a, b, c) (d, e, f) : point = (Q.sub a d, Q.sub b e, Q.sub c f)

let cross (a, b, c) (d, e, f) : point =
  Q.((b * f) - (c * e), (c * d) - (a * f), (a * e) - (b * d))

let dot (a, b, c) (d, e, f) = Q.((a * d) + (b * e) + (c * f))

let triangles faces =
  let fan = function
    | first :: second :: rest ->
      let add (previous, found) next = (next, (first, previous, next) :: found) in
      snd (List.fold_left add (second, []) rest)
    | _ -> []
  in
  List.concat_map fan faces

(* Tetrahedra at the first vertex, each with the products by which it tells weights *)
type cone = { corners : int * int * int; ways : point * point * point; rough : float array }

let cones (vertices, faces) =
  let at = Array.of_list vertices in
  let cone (i, j, k) =
    let u = at.(i) -- at.(0) and v = at.(j) -- at.(0) and w = at.(k) -- at.(0) in
    let size = dot u (cross v w) in
    if Q.sign size = 0 then None
    else
      let over (a, b, c) = Q.(a / size, b / size, c / size) in
      let ((a, b, c), (d, e, f), (g, h, l)) as ways =
        (over (cross v w), over (cross w u), over (cross u v))
      in
      let rough = Array.map Q.to_float [| a; b; c; d; e; f; g; h; l |] in
      Some { corners = (i, j, k); ways; rough }
  in
  Array.of_list (List.filter_map cone (triangles faces))

let weights cone x =
  let a, b, c = cone.ways in
  let i, j, k = cone.corners in
  let s = dot a x and t = dot b x and u = dot c x in
  let rest = Q.(one - s - t - u) in
  let all = [ (0, rest); (i, s); (j, t); (k, u) ] in
  if List.exists (fun (_, w) -> Q.sign w < 0) all then None
  else Some (List.filter (fun (_, w) -> Q.sign w > 0) all)

(* Doubles propose a tetrahedron; where it is the wrong one all are tried. *)
let mean cones first x =
  let ((a, b, c) as way) = x -- first in
  let a = Q.to_float a and b = Q.to_float b and c = Q.to_float c in
  let best = ref 0 and most = ref neg_infinity in
  Array.iteri
    (fun n { rough = m; _ } ->
      let s = (m.(0) *. a) +. (m.(1) *. b) +. (m.(2) *. c)
      and t = (m.(3) *. a) +. (m.(4) *. b) +. (m.(5) *. c)
      and u = (m.(6) *. a) +. (m.(7) *. b) +. (m.(8) *. c) in
      let least = Float.min (Float.min s t) (Float.min u (1. -. s -. t -. u)) in
      if least > !most then (most := least; best := n))
    cones;
  let tried = if Array.length cones = 0 then None else weights cones.(!best) way in
  let rec search n =
    if n = Array.length cones then fail Refuted "the sum of two vertices is outside"
    else match weights cones.(n) way with Some found -> found | None -> search (n + 1)
  in
  match tried with Some found -> found | None -> search 0

let all budget (sx, sy, sz) of_p of_q ((vertices, _) as mesh) =
  let cones = cones mesh in
  List.map
    (fun (a, b, c) ->
      List.map
        (fun (d, e, f) ->
          budget (1 + Array.length cones);
          mean cones (List.hd vertices) Q.((sx * a) + d, (sy * b) + e, (sz * c) + f))
        of_q)
    of_p

let area_vector ring =
  let add n (p, q) =
    let (a, b, c), (d, e, f) = (n, cross p q) in
    Q.(a + d, b + e, c + f)
  in
  List.fold_left add (Q.zero, Q.zero, Q.zero) (Rings.edges_of ring)

(* The numbers of the points that are farthest along n *)
let farthest n points =
  let levels = Array.map (dot n) points in
  let most = Array.fold_left Q.max levels.(0) levels in
  List.filter (fun i -> Q.equal levels.(i) most) (List.init (Array.length levels) Fun.id)

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
