(* Step `clear` of a path-certificate: its codes, followed over cells. Not trusted: where it is
   wrong, the checker says no. *)

open Failure
open Json
open Rings
open Cells

type sides = { of_r : Pieces.side; of_o : Pieces.side }

(* A segment of places from p to q: p(s) + t d, 0 <= t <= length + growth s *)
type segment = {
  start : Reading.mover;
  along : point;
  length : Q.t;
  growth : Q.t;
  corners : (Q.t * Q.t * Q.t) list;
  within : bound list;
}

let segment (i : Reading.scales) (p, q) =
  let d0 = starts q -- starts p and d1 = speeds q -- speeds p in
  let off s = d0 ++ times s d1 in
  let first = off i.low and last = match i.high with Some b -> off b | None -> d1 in
  demand
    (Q.sign (cross first last) = 0 && Q.sign (dot first last) >= 0)
    "a segment turns as the scale changes";
  let along = first ++ last in
  let square = dot along along in
  let part v = if Q.sign square = 0 then Q.zero else Q.(dot v along / square) in
  let length = part d0 and growth = part d1 in
  let reach s = Q.(length + (growth * s)) in
  let top =
    match i.high with
    | Some b -> [ (reach b, b, Q.one); (Q.zero, b, Q.one) ]
    | None -> [ (growth, Q.one, Q.zero); (Q.zero, Q.one, Q.zero) ]
  in
  let bound ?(strict = false) a b c = { at_least = { a; b; c }; strict } in
  let zero = Q.zero and one = Q.one and minus_one = Q.minus_one in
  {
    start = p; along; length; growth;
    corners = [ (zero, i.low, one); (reach i.low, i.low, one) ] @ top;
    within =
      [ bound one zero zero; bound minus_one growth length;
        bound zero one (Q.neg i.low) ~strict:((not i.low_in) || Q.sign i.low <= 0) ]
      @ (match i.high with
         | Some b -> [ bound zero minus_one b ~strict:(not i.high_in) ]
         | None -> []);
  }

(* f of a normal and the hulls of two nodes *)
let level segment n hull_a hull_b =
  {
    a = dot n segment.along;
    b = Q.sub (dot n (speeds segment.start)) (support (opposite n) hull_a);
    c = Q.sub (dot n (starts segment.start)) (support n hull_b);
  }

(* At a single scale places stay where they are then. *)
let freezing (i : Reading.scales) path =
  match i.high with
  | Some b when Q.equal i.low b -> List.map (fun m -> stays (at b m)) path
  | _ -> path

(* A code, followed over the cells of a segment *)
let follow budget contact scales sides normals segment code =
  let { Pieces.pieces = of_r; _ } = sides.of_r and { Pieces.pieces = of_o; _ } = sides.of_o in
  let roots =
    match (Array.length of_r.hulls, Array.length of_o.hulls) with
    | 0, _ | _, 0 -> []
    | n, m -> [ (segment.corners, segment.within, n - 1, m - 1) ]
  in
  let is_empty = roots = [] in
  let split children = demand (children <> []) "a code splits a piece"; children in
  let entry (stack, said) token =
    budget 1;
    match stack with
    | [] -> fail Refuted "a code goes on after its end"
    | (cell, bounds, a, b) :: rest -> (
      let n = integer token in
      match if Z.fits_int n then Z.to_int n else 0 with
      | -1 ->
        let opened = List.map (fun a -> (cell, bounds, a, b)) (split of_r.children.(a)) in
        (opened @ rest, Checked.open_part :: said)
      | -2 ->
        let opened = List.map (fun b -> (cell, bounds, a, b)) (split of_o.children.(b)) in
        (opened @ rest, Checked.open_obstacles :: said)
      | -3 ->
        let finite (t, _, w) = if Q.sign w = 0 then None else Some t in
        let found = List.filter_map finite cell in
        demand (found <> []) "a cell has no middle";
        let least = List.fold_left Q.min (List.hd found) found
        and most = List.fold_left Q.max (List.hd found) found in
        let t = Q.((least + most) / of_int 2) in
        let above = { a = Q.one; b = Q.zero; c = Q.neg t } in
        let half f =
          (not_above f cell, { at_least = negative f; strict = false } :: bounds, a, b)
        in
        (half above :: half (negative above) :: rest, Checked.cut_at t :: said)
      | _ ->
        let n = normals.(index token (Array.length normals)) in
        budget (List.length cell);
        let f = level segment n of_r.hulls.(a) of_o.hulls.(b) in
        let left = not_above f cell in
        let overlap =
          contact = Reading.Forbidden || List.exists (fun c -> Q.sign (value f c) < 0) cell
        in
        let new_ = { at_least = negative f; strict = contact = Reading.Allowed } :: bounds in
        if overlap && meets scales left then ((left, new_, a, b) :: rest, Checked.across n :: said)
        else (rest, Checked.nothing_left (contradiction new_) :: Checked.across n :: said))
  in
  let stack, said = List.fold_left entry (roots, []) (items code) in
  demand (stack = []) "a code ends too early";
  if is_empty then []
  else [ Checked.way segment.along segment.length segment.growth (List.rev said) ]

(* Step `clear` *)
type clear = {
  by : int * int;  (* the numbers of the steps `pieces` *)
  contact : Reading.contact;
  scales : Reading.scales;
  path : Reading.mover list;  (* as in the file *)
  ways : Checked.way list;
}

let clear budget contact_of sides_of case_path step =
  match members step [ "rule"; "by"; "contact"; "path"; "scales"; "normals"; "codes" ] with
  | [ _; by; contact; path; scales; normals; codes ] ->
    let by, sides = sides_of by in
    let contact = contact_of contact in
    let path = if path = Null then List.map stays case_path else List.map place (items path) in
    require (path <> []) "a path has no place";
    let scales = Reading.scales scales in
    let normals = Array.of_list (List.map Elaborate.normal (items normals)) in
    let pairs = segments (freezing scales path) and codes = items codes in
    require (List.compare_lengths pairs codes = 0) "there are not as many codes as segments";
    let way i pair code =
      within (Printf.sprintf "segment %d" i) (fun () ->
          follow budget contact scales sides normals (segment scales pair) code)
    in
    let ways = List.concat (List.mapi (fun i (pair, code) -> way i pair code)
                              (List.combine pairs codes)) in
    { by; contact; scales; path; ways }
  | _ -> assert false

(* Whether claims follow each other from end to end; those of the first kind have these scales. *)
let demand_order window told parts =
  let ends = lower window :: List.map (fun (_, scales) -> upper scales) parts
  and begins = List.map (fun (_, scales) -> lower scales) parts @ [ upper window ] in
  let same = List.equal (fun c d -> compare_cuts c d = 0) in
  demand (same ends begins) "the claims do not follow each other from end to end";
  let rec joined = function
    | (true, i) :: (true, (j : Reading.scales)) :: rest ->
      joined ((true, { i with Reading.high = j.high; high_in = j.high_in }) :: rest)
    | (true, i) :: rest -> i :: joined rest
    | (false, _) :: rest -> joined rest
    | [] -> []
  in
  demand (List.equal same_scales (joined parts) told) "the scales are others"
