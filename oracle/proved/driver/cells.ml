(* Scales, places that move with them, and cells of all t and s, for paths and traps. Not trusted:
   it says by which multiples of its bounds a cell is empty. *)

open Failure
open Json
open Rings

let dot (a, b) (c, d) = Q.((a * c) + (b * d))
let opposite (x, y) = (Q.neg x, Q.neg y)

let support n = function
  | [] -> Q.zero
  | p :: rest -> List.fold_left (fun m v -> Q.max m (dot n v)) (dot n p) rest

(* Ends of scales as cuts between numbers: just below a number, or above; None is infinity. *)
type cut = Q.t option * bool

let lower ({ low; low_in; _ } : Reading.scales) : cut = (Some low, not low_in)
let upper ({ high; high_in; _ } : Reading.scales) : cut = (high, high_in)

let compare_cuts ((a, above) : cut) ((b, over) : cut) =
  match (a, b) with
  | Some a, Some b when not (Q.equal a b) -> Q.compare a b
  | Some _, None -> -1
  | None, Some _ -> 1
  | _ -> compare above over

let same_scales i j =
  compare_cuts (lower i) (lower j) = 0 && compare_cuts (upper i) (upper j) = 0

(* One of the scales *)
let some_scale ({ low; high; _ } : Reading.scales) =
  match high with None -> Q.(low + one) | Some b -> Q.((low + b) / of_int 2)

(* Places that move *)
let starts (m : Reading.mover) = (m.x0, m.y0)
let speeds (m : Reading.mover) = (m.x1, m.y1)
let mover (x0, y0) (x1, y1) : Reading.mover = { x0; x1; y0; y1 }
let stays p = mover p (Q.zero, Q.zero)
let at s m = starts m ++ times s (speeds m)
let same_movers m n = Reading.compare_movers m n = 0

let place value =
  match items value with [ _; _ ] -> stays (Reading.point value) | _ -> Reading.mover value

(* What moves from p at the scale a to q at b *)
let between a p b q =
  let speed = times (Q.inv (Q.sub b a)) (q -- p) in
  mover (p -- times a speed) speed

let segments path =
  let rec from = function a :: (b :: _ as rest) -> (a, b) :: from rest | _ -> [] in
  match path with [ a ] -> [ (a, a) ] | _ -> from path

(* Linear functions a t + b s + c *)
type linear = { a : Q.t; b : Q.t; c : Q.t }
type bound = { at_least : linear; strict : bool }

let negative f = { a = Q.neg f.a; b = Q.neg f.b; c = Q.neg f.c }

(* Bounds of which multiples add up to a contradiction: one, two or three of them. The first of the
   list is the last that was added, and most often among them. *)
let contradiction bounds =
  let all = Array.of_list bounds in
  let n = Array.length all in
  let direction i = (all.(i).at_least.a, all.(i).at_least.b) in
  let fits found =
    let add sum (i, m) = Q.(sum + (m * all.(i).at_least.c)) in
    let sum = Q.sign (List.fold_left add Q.zero found) in
    sum < 0 || (sum = 0 && List.exists (fun (i, m) -> all.(i).strict && Q.sign m > 0) found)
  in
  let one i = if Q.sign (dot (direction i) (direction i)) = 0 then [ (i, Q.one) ] else [] in
  let two i j =
    let u = direction i and v = direction j in
    if Q.sign (cross u v) = 0 && Q.sign (dot u v) < 0 then
      [ (i, Q.neg (dot u v)); (j, dot u u) ]
    else []
  in
  let three i j k =
    let u = direction i and v = direction j and w = direction k in
    let found = [ (i, cross v w); (j, cross w u); (k, cross u v) ] in
    let signs = List.map (fun (_, m) -> Q.sign m) found in
    if List.for_all (( < ) 0) signs then found
    else if List.for_all (( > ) 0) signs then List.map (fun (i, m) -> (i, Q.neg m)) found
    else []
  in
  let exception Found of (int * Q.t) list in
  let attempt found = if found <> [] && fits found then raise_notrace (Found found) in
  match
    for i = 0 to n - 1 do
      attempt (one i);
      for j = i + 1 to n - 1 do
        attempt (two i j);
        for k = j + 1 to n - 1 do
          attempt (three i j k)
        done
      done
    done
  with
  | () -> fail Refuted "nothing shows that a cell is empty"
  | exception Found found ->
    List.mapi (fun i _ -> Option.value (List.assoc_opt i found) ~default:Q.zero) bounds

(* Corners (t, s, w) of a cell: t / w and s / w; w = 0 is far up. *)
let value f (t, s, w) = Q.((f.a * t) + (f.b * s) + (f.c * w))

let not_above f cell =
  let corner (t, s, w) =
    let by = if Q.sign w = 0 then s else w in
    Q.(t / by, s / by, w / by)
  in
  let kept (p, c) =
    let level = value f c and before = value f p in
    let mean x y = Q.((abs before * x) + (abs level * y)) in
    let cut =
      if Q.sign level * Q.sign before < 0 then
        let (t, s, w), (t', s', w') = (c, p) in
        [ corner (mean t t', mean s s', mean w w') ]
      else []
    in
    cut @ if Q.sign level <= 0 then [ c ] else []
  in
  let same (a, b, c) (d, e, f) = Q.equal a d && Q.equal b e && Q.equal c f in
  List.fold_left
    (fun found c -> if List.exists (same c) found then found else found @ [ c ])
    []
    (List.concat_map kept (edges_of cell))

(* Whether corners are not all at an end that does not belong to the scales *)
let meets (i : Reading.scales) corners =
  let ends =
    (if i.low_in then [] else [ (i.low, Q.one) ])
    @
    if i.high_in then []
    else [ (match i.high with Some b -> (b, Q.one) | None -> (Q.one, Q.zero)) ]
  in
  let is_at (s, w) (_, s', w') = Q.equal Q.(s' * w) Q.(s * w') in
  corners <> [] && not (List.exists (fun end_ -> List.for_all (is_at end_) corners) ends)
