(* Points that solids of the part and the obstacles share, for hits and for the rings of traps. Not
   trusted: where it is wrong, the checker says no. *)

open Failure
open Json
open Rings
open Cells
open Ways

(* Half-planes n p + h >= 0 that have a convex polygon, a segment or a point in common *)
let half_planes hull =
  let from n a = (n, Q.neg (dot n a)) in
  let left (x, y) = (Q.neg y, x) in
  let strip n a b = [ from n a; from (opposite n) b ] in
  match hull with
  | [ a ] -> strip (Q.one, Q.zero) a a @ strip (Q.zero, Q.one) a a
  | [ a; b ] ->
    let n = if compare_points a b = 0 then (Q.one, Q.zero) else b -- a in
    strip n a b @ strip (left n) a b
  | _ -> List.map (fun (a, b) -> from (left (b -- a)) a) (edges_of hull)

let level_there (n, h) y = Q.(dot n y + h)
let level_here (n, h) x y s = Q.(dot n (y -- x) + (s * h))

let solid budget side number =
  let hulls = side.Pieces.pieces.hulls in
  let n = index number (Array.length hulls) in
  (fst (Pieces.solid budget side n), hulls.(n))

(* A hit: from where to where, and what it is for the checker *)
let hit budget contact sides path value =
  match members value [ "segment"; "nodes"; "points" ] with
  | [ segment; nodes; points ] ->
    let all = Array.of_list (segments path) in
    let segment = index segment (Array.length all) in
    let p, q = all.(segment) in
    let first, second = pair nodes in
    let i, a = solid budget sides.of_r first and j, b = solid budget sides.of_o second in
    let of_a = half_planes a and of_b = half_planes b in
    let rec entries = function
      | [] -> ([], false)
      | [ Text "up" ] -> ([], true)
      | entry :: rest -> (
        let found, up = entries rest in
        match items entry with
        | [ t; s; y ] -> ((number t, number s, Reading.point y) :: found, up)
        | _ -> fail Malformed "an entry has three members")
    in
    let found, up = entries (items points) in
    require (found <> []) "a hit has no point";
    let levels (t, s, y) =
      budget (List.length of_a + List.length of_b);
      require (Q.sign t >= 0 && Q.leq t Q.one && Q.sign s >= 0) "this is no place, or no scale";
      let x = p ++ times t (q -- p) in
      List.map (fun l -> level_here l x y s) of_a @ List.map (fun l -> level_there l y) of_b
    in
    let far = if up then [ List.map snd of_a @ List.map (fun _ -> Q.zero) of_b ] else [] in
    let levels = List.map levels found @ far in
    let holds = List.for_all (fun l -> Q.sign l > 0) in
    let none_out = List.for_all (fun l -> Q.sign l >= 0) in
    demand (List.for_all none_out levels) "a point is not in its piece";
    let inside = List.map (fun l -> contact = Reading.Forbidden || holds l) levels in
    let rec ascend = function
      | (_, s, _) :: ((_, u, _) :: _ as rest) -> Q.lt s u && ascend rest
      | _ -> true
    in
    require (ascend found) "the scales do not ascend";
    let inner = List.filteri (fun k _ -> k > 0 && k + 1 < List.length inside) inside in
    let rec crosses = function
      | l :: (m :: _ as rest) ->
        List.for_all2 (fun u v -> Q.sign u > 0 || Q.sign v > 0) l m && crosses rest
      | _ -> true
    in
    demand
      (contact = Reading.Forbidden || (List.for_all Fun.id inner && crosses levels))
      "a point is not in the interior of its piece";
    let made low high low_in high_in (t, s, y) next =
      let start, speed, shared =
        match next with
        | Some (t', s', y') ->
          let speed = Q.((t' - t) / (s' - s)) in
          (Q.(t - (s * speed)), speed, between s y s' y')
        | None -> (t, Q.zero, stays y)
      in
      Checked.hit { Reading.low; high; low_in; high_in } segment (start, speed) (i, j) shared
    in
    let scale (_, s, _) = s in
    let rec all_hits entries inside =
      match (entries, inside) with
      | e :: (f :: _ as rest), low_in :: (high_in :: _ as more) ->
        made (scale e) (Some (scale f)) low_in high_in e (Some f) :: all_hits rest more
      | [ e ], low_in :: _ when up -> [ made (scale e) None low_in false e None ]
      | _ -> []
    in
    let hits =
      match (found, inside) with
      | [ e ], [ is_in ] -> [ made (scale e) (Some (scale e)) is_in is_in e None ]
      | _ -> all_hits found inside
    in
    let s = scale (List.hd found) in
    let low : cut = (Some s, not (List.hd inside && Q.sign s > 0)) in
    let last = List.hd (List.rev found) in
    let high : cut =
      if up then (None, false) else (Some (scale last), List.hd (List.rev inside))
    in
    (low, high, hits)
  | _ -> assert false

let hits budget contact scales sides path values =
  let add (i, reach, found) value =
    within (Printf.sprintf "hit %d" i) (fun () ->
        let low, high, hits = hit budget contact sides path value in
        demand
          (compare_cuts low reach <= 0 && compare_cuts reach high < 0)
          "it leaves out scales before it, or adds none";
        (i + 1, high, hits :: found))
  in
  let _, reached, found = List.fold_left add (0, lower scales, []) (items values) in
  demand (compare_cuts reached (upper scales) >= 0) "the hits do not reach to the last scale";
  List.concat (List.rev found)

(* A point in a solid of O and, less the place x, in s times one of R: the mean of the corners of
   what they have in common *)
let shared x s a b =
  let clip body plane =
    let level y = level_here plane x y s in
    List.concat_map
      (fun (p, q) ->
        let u = level p and v = level q in
        (if Q.sign u >= 0 then [ p ] else [])
        @
        if Q.sign u * Q.sign v < 0 then [ p ++ times Q.(u / (u - v)) (q -- p) ] else [])
      (edges_of body)
  in
  match List.fold_left clip b (half_planes a) with
  | [] -> fail Refuted "an edge is not in the sum of two solids"
  | found ->
    times (Q.of_ints 1 (List.length found)) (List.fold_left ( ++ ) (Q.zero, Q.zero) found)

(* An edge of a ring, with points that two solids share at both ends *)
let edge budget contact (scales : Reading.scales) sides (c, d) nodes =
  let first, second = pair nodes in
  let i, a = solid budget sides.of_r first and j, b = solid budget sides.of_o second in
  let turned = List.map (fun (n, h) -> (n, h, true)) (half_planes a)
  and others = List.map (fun (n, h) -> (opposite n, h, false)) (half_planes b) in
  List.iter
    (fun corner ->
      List.iter
        (fun (n, _, _) ->
          budget 2;
          let far = Q.sub (dot n (starts corner)) (support n b)
          and grows = Q.sub (dot n (speeds corner)) (support (opposite n) a) in
          let there s w = Q.((grows * s) + (far * w)) in
          let low = there scales.low Q.one
          and high =
            match scales.high with Some s -> there s Q.one | None -> there Q.one Q.zero
          in
          let zero is_in level = is_in && Q.sign level = 0 in
          let both = Q.sign low = 0 && Q.sign high = 0 in
          demand
            (Q.sign low <= 0 && Q.sign high <= 0
            && (contact = Reading.Forbidden
               || not (both || zero scales.low_in low || zero scales.high_in high)))
            "an edge is not in the sum of two solids")
        (turned @ others))
    [ c; d ];
  let point s corner = shared (at s corner) s a b in
  let still at_ = (at_, stays (point at_.Reading.low c), stays (point at_.low d)) in
  let moves at_ s u =
    (at_, between s (point s c) u (point u c), between s (point s d) u (point u d))
  in
  let low = scales.low and m = some_scale scales in
  let hits =
    match (contact, scales.high) with
    | _, Some b when Q.equal low b -> [ still scales ]
    | Reading.Forbidden, None -> [ still scales ]
    | Forbidden, Some b -> [ moves scales low b ]
    | Allowed, high -> (
      let before = { scales with high = Some m; high_in = true }
      and after = { scales with low = m; low_in = true } in
      moves before low m
      :: (match high with None -> [ still after ] | Some b -> [ moves after m b ]))
  in
  Checked.edge (i, j) hits

let trap budget contact scales sides ring pairs here_free =
  let ring = List.map Reading.mover (items ring) and pairs = items pairs in
  require (List.compare_lengths ring pairs = 0) "there are not as many pairs as edges";
  let edges = List.map2 (edge budget contact scales sides) (edges_of ring) pairs in
  Checked.trap (some_scale scales) ring edges here_free
