(* The claims of a certificate-v1. Trusted: what is said to be proved is what [Checked] was asked,
   of the sets that [Reading] found. *)

open Failure
open Json

(* A region with the tests that it took: they are spent for each claim, as each proves it again. *)
type step = Pieces of Pieces.pieces | Region of Elaborate.region Lazy.t * int ref

(* A claim: what is said if it holds, and whether it does. What an event is proved with is not
   asked again. *)
type claim = {
  said : string;
  theorem : (out_channel -> unit) option;
  shown : Intervals.shown;
  holds : bool Lazy.t;
  mutable follows : bool;
  mutable tests : int;
}

type proved = { said : string; theorem : (out_channel -> unit) option }

let kinds = [ "sum"; "interval"; "event"; "events"; "point"; "outside"; "passage"; "sign" ]
let shown_point (x, y) = Printf.sprintf "(%s, %s)" (Q.to_string x) (Q.to_string y)

(* The point is s a + b, a in P, b in Q, and it is in the sum, as decided from the sets alone *)
let is_thin_point budget s (p : Reading.operand) (q : Reading.operand) x (ax, ay) (bx, by) =
  let origin : Checked.set = [ { outer = [ (Q.zero, Q.zero) ]; holes = [] } ] in
  let n = 1 + Array.length p.vertices and m = 1 + Array.length q.vertices in
  budget ((n + m) * (n + m));
  let is_in s p q x =
    match Checked.decide_points s p q [ x ] with
    | Some answers -> answers = [ true ]
    | None -> fail Declined "there is no theorem about points of an operand that is not legal"
  in
  Reading.same x Q.((s * ax) + bx, (s * ay) + by)
  && is_in Q.one p.polygons origin (ax, ay)
  && is_in Q.one q.polygons origin (bx, by)
  && is_in s p.polygons q.polygons x

let check_claim budget p q step claim_of claim =
  budget 64;
  let kind =
    match claim with
    | Object found -> (
      match List.assoc_opt "claim" found with Some (Text kind) -> kind | _ -> "")
    | _ -> ""
  in
  if kind = "passages" then fail Declined "there is no theorem about all passages of a sum yet";
  require (List.mem kind kinds) "there is no such claim";
  let rings (o : Reading.operand) = Reading.rings_of o.polygons in
  let region at =
    match step at with
    | Region (found, tests) ->
      if Lazy.is_val found then budget !tests;
      Lazy.force found
    | _ -> fail Malformed "this is no sum's step"
  in
  let at_scale s at =
    let region = region at in
    demand (List.equal Q.equal region.Elaborate.scales [ s ]) "the step is about another scale";
    region
  in
  let pieces_of name at =
    match step at with
    | Pieces pieces ->
      require (pieces.operand.name = name) "`by` is not of P and Q";
      pieces
    | _ -> fail Malformed "this is no step of pieces"
  in
  let found ?theorem ?(shown = Intervals.Another) said holds =
    { said = kind ^ ": " ^ said; theorem; shown; holds; follows = false; tests = 0 }
  in
  match kind with
  | "sum" -> (
    match
      members claim [ "claim"; "scale"; "step"; "components"; "holes"; "digest"; "polygons?" ]
    with
    | [ _; scale; at; components; holes; digest; polygons ] ->
      let s = Intervals.scale_of scale and digest = text digest in
      let region = at_scale s at in
      let derivation = region.derivation region.form in
      let enclosed = Checked.holes_in derivation in
      let there = Moving.there region enclosed in
      let result = there.polygons in
      demand (Reading.digest_of (Reading.polygons_text result) = digest) "the digest is another";
      (match polygons with
       | Null -> ()
       | given ->
         let same = canonical_text given = Reading.polygons_text result in
         demand same "the polygons are others");
      let count = List.length result in
      demand (Z.equal (integer components) (Z.of_int count)) "components are others";
      demand (Z.equal (integer holes) (Z.of_int enclosed)) "holes are others";
      let said =
        Printf.sprintf
          "at %s, the set of points of digest %s, in canonical form, of %d components and %d holes"
          (Q.to_string s) digest count enclosed
      in
      found said
        ~theorem:(fun out -> Theorem.write out s (rings p) (rings q) result derivation)
        ~shown:(Sum { scale = s; there; derivation })
        (lazy (Checked.sum_holds s (rings p) (rings q) result derivation))
    | _ -> assert false)
  | "interval" ->
    let interval, digest, said, holds = Intervals.interval (rings p) (rings q) region claim in
    found said ~shown:(Interval (interval, digest)) holds
  | "event" ->
    let asked = ref [] in
    let shown value =
      let (other : claim) = claim_of value in
      asked := other :: !asked;
      budget other.tests;
      other.shown
    in
    let said, shown = Intervals.event (rings p) (rings q) shown claim in
    List.iter (fun (other : claim) -> other.follows <- true) !asked;
    found said ~shown (lazy true)
  | "events" ->
    let said = Intervals.events (fun value -> (claim_of value : claim).shown) claim in
    found said (lazy true)
  | "point" -> (
    match members claim [ "claim"; "scale"; "point"; "p"; "q"; "by"; "pieces" ] with
    | [ _; scale; x; a; b; by; nodes ] ->
      let s = Intervals.scale_of scale in
      let x = Reading.point x and a = Reading.point a and b = Reading.point b in
      let first, second = pair by and i, j = pair nodes in
      let said = Printf.sprintf "%s at %s is a point of the sum" (shown_point x) (Q.to_string s) in
      let piece name at node =
        let pieces = pieces_of name at in
        let n = index node (Array.length pieces.hulls) in
        require (pieces.children.(n) = []) "this is no piece";
        (pieces, n)
      in
      let first = piece "P" first i and second = piece "Q" second j in
      if Reading.is_thin p || Reading.is_thin q then
        found said (lazy (is_thin_point budget s p q x a b))
      else
        let side (pieces, n) =
          let side = Pieces.side pieces budget [ Q.one ] in
          require (Hashtbl.mem side.place n) "a piece is in no group";
          (Pieces.tiled side, Hashtbl.find side.place n)
        in
        let tiled_p, i = side first and tiled_q, j = side second in
        found said
          ~theorem:(fun out ->
            Point_theorem.inside out s (rings p) (rings q) x (a, b) tiled_p tiled_q i j)
          (lazy (Checked.point_holds s (rings p) (rings q) x a b tiled_p tiled_q i j))
    | _ -> assert false)
  | "outside" -> (
    match members claim [ "claim"; "scale"; "point"; "by"; "normals"; "code" ] with
    | [ _; scale; x; by; normals; code ] ->
      let s = Intervals.scale_of scale and x = Reading.point x in
      let first, second = pair by in
      let side name at factor = Pieces.side (pieces_of name at) budget [ factor ] in
      let of_p = side "P" first s and of_q = side "Q" second Q.one in
      let normals = Array.of_list (List.map Elaborate.normal (items normals)) in
      let code = List.map (fun entry -> budget 1; Elaborate.token normals entry) (items code) in
      let is_empty (o : Reading.operand) = o.polygons = [] in
      demand (code = [] || not (is_empty p || is_empty q)) "a code goes on after its end";
      let tiled_p = Pieces.tiled of_p and tiled_q = Pieces.tiled of_q in
      found
        (Printf.sprintf "%s at %s is no point of the sum" (shown_point x) (Q.to_string s))
        ~theorem:(fun out ->
          Point_theorem.outside out s (rings p) (rings q) x tiled_p tiled_q code)
        (lazy (Checked.outside_holds s (rings p) (rings q) x tiled_p tiled_q code))
    | _ -> assert false)
  | "sign" -> (
    match members claim [ "claim"; "of"; "from"; "to"; "sign" ] with
    | [ _; predicate; from; to_; sign ] ->
      let a' = number from and b' = number to_ and z = integer sign in
      require (Q.sign a' > 0 && Q.sign b' > 0) "a scale is not positive";
      require (Q.compare a' b' <= 0) "the scales do not ascend";
      require (Z.compare (Z.abs z) Z.one <= 0) "this is no sign";
      let place value : Checked.place =
        let i, j = pair value in
        let vertex (o : Reading.operand) = function
          | Null -> None
          | given -> Some (index given (Array.length o.vertices))
        in
        (vertex p i, vertex q j)
      in
      let name, entries = pair predicate in
      let of_ =
        match (text name, items entries) with
        | "orientation", [ u; v; w ] -> Checked.orientation (place u) (place v) (place w)
        | "concurrent", [ k; l; m ] ->
          let (a, b), (c, d), (e, f) = (pair k, pair l, pair m) in
          let line (u, v) =
            let at s = List.map (Reading.place s p.vertices q.vertices) [ place u; place v ] in
            let is_point s = match at s with [ x; y ] -> Reading.same x y | _ -> true in
            require (not (is_point a' && is_point b')) "a line has one point given twice"
          in
          List.iter line [ (a, b); (c, d); (e, f) ];
          Checked.concurrent (place a) (place b) (place c) (place d) (place e) (place f)
        | _ -> fail Malformed "there is no such predicate"
      in
      found
        (Printf.sprintf "%s has the sign %s from %s to %s" (canonical_text predicate)
           (Z.to_string z) (Q.to_string a') (Q.to_string b'))
        (lazy (Checked.sign_holds (rings p) (rings q) of_ a' b' z))
    | _ -> assert false)
  | "passage" -> (
    match members claim [ "claim"; "scale"; "step"; "points"; "path" ] with
    | [ _; scale; at; points; path ] ->
      let s = Intervals.scale_of scale in
      let region = at_scale s at in
      let thin = Reading.is_thin p || Reading.is_thin q in
      require (not thin) "passages of a point or a segment are not proven by contacts";
      let points = List.map Reading.point (items points) in
      let met = List.map region.point (items path) in
      require (met <> []) "a passage has no point";
      let same (a, b) at =
        match at with [ (c, d) ] -> Q.equal a c && Q.equal b d | _ -> false
      in
      demand
        (List.compare_lengths points met = 0
        && List.for_all2 (fun given (_, at) -> same given at) points met)
        "the points are others";
      let contacts = Elaborate.contacts region (List.map fst met) in
      let x, y = List.hd points in
      found
        (Printf.sprintf "at %s, of %d points, from (%s, %s)" (Q.to_string s) (List.length points)
           (Q.to_string x) (Q.to_string y))
        (lazy
          (Checked.passage_holds s (rings p) (rings q)
             (region.derivation region.form)
             points contacts))
    | _ -> assert false)
  | _ -> assert false

(* P scaled by a factor for each axis, and the words for it: what is proved is about this set. *)
let scaled_by axes (p : Reading.operand) =
  let x, y = pair axes in
  let x = Intervals.scale_of x and y = Intervals.scale_of y in
  let vertex (a, b) = Q.(x * a, y * b) in
  let ring = List.map vertex in
  let polygon ({ outer; holes } : Reading.point Reading.polygon) : _ Reading.polygon =
    { outer = ring outer; holes = List.map ring holes }
  in
  ( { p with polygons = List.map polygon p.polygons; vertices = Array.map vertex p.vertices },
    Printf.sprintf "P by %s,%s: " (Q.to_string x) (Q.to_string y) )

let check_plane ~has_axes certificate read_case budget =
  let spent = ref 0 in
  let budget tests =
    spent := !spent + tests;
    budget tests
  in
  let argument = if has_axes then [ "axes"; "steps" ] else [ "steps" ] in
  let names = [ "certificate"; "title?"; "comment?"; "producer?"; "case" ] in
  match members certificate (names @ argument @ [ "claims" ]) with
  | _ :: title :: comment :: producer :: case :: argued ->
    let axes, steps, claims =
      match argued with
      | [ axes; steps; claims ] -> (Some axes, steps, claims)
      | [ steps; claims ] -> (None, steps, claims)
      | _ -> assert false
    in
    let path, digest = Reading.head [ title; comment; producer ] case in
    let p, q =
      match read_case path with
      | Object found ->
        let operand name =
          match List.assoc_opt name found with
          | Some value -> Reading.operand name value
          | None -> fail Malformed ("the case has no " ^ name)
        in
        (operand "P", operand "Q")
      | _ -> fail Malformed "this is no case"
    in
    demand (Reading.case_digest p q = digest) "not the case that is certified";
    let p, scaled = match axes with Some axes -> scaled_by axes p | None -> (p, "") in
    require (not (Reading.is_thin p && Reading.is_thin q)) "both operands are points or segments";
    let operand_of = function
      | "P" -> p
      | "Q" -> q
      | _ -> fail Malformed "there is no such operand"
    in
    let given = Array.of_list (items steps) in
    let made = Array.make (Array.length given) None in
    let used = Hashtbl.create 16 in
    let step_before bound value =
      let i = index value bound in
      Hashtbl.replace used i ();
      Option.get made.(i)
    in
    Array.iteri
      (fun i step ->
        within (Printf.sprintf "step %d" i) (fun () ->
            let rule =
              match step with
              | Object found -> (
                match List.assoc_opt "rule" found with Some (Text rule) -> rule | _ -> "")
              | _ -> ""
            in
            let pieces_of value name =
              match step_before i value with
              | Pieces found when found.operand.name = name -> found
              | _ -> fail Malformed "`by` is not of P and Q"
            in
            let step =
              match rule with
              | "pieces" -> Pieces (Pieces.pieces_step operand_of budget step)
              | "eq" | "move" -> (
                match members step Elaborate.names with
                | _ :: _ :: by :: _ ->
                  let a, b = pair by in
                  let by = (pieces_of a "P", pieces_of b "Q") in
                  let tests = ref 0 in
                  let found () =
                    let before = !spent in
                    let region = Elaborate.region p q by budget step in
                    tests := !spent - before;
                    region
                  in
                  Region (Lazy.from_fun found, tests)
                | _ -> assert false)
              | _ -> fail Malformed "there is no such rule"
            in
            made.(i) <- Some step))
      given;
    let claims = items claims in
    require (claims <> []) "nothing is claimed";
    let found = Array.make (List.length claims) None in
    let place i = Printf.sprintf "claim %d" i in
    List.iteri
      (fun i claim ->
        let claim_of value = Option.get found.(index value i) in
        let step = step_before (Array.length given) in
        let before = !spent in
        let claim = within (place i) (fun () -> check_claim budget p q step claim_of claim) in
        claim.tests <- !spent - before;
        found.(i) <- Some claim)
      claims;
    require (Hashtbl.length used = Array.length given) "a step is not used";
    require
      (List.length (List.sort_uniq compare (List.map canonical_text claims)) = List.length claims)
      "a claim is made twice";
    let proved i claim =
      let { said; theorem; holds; follows; _ } : claim = Option.get claim in
      within (place i) (fun () ->
          demand (follows || Lazy.force holds) "the proved checker does not take this for a proof");
      ({ said = scaled ^ said; theorem } : proved)
    in
    List.mapi proved (Array.to_list found)
  | _ -> assert false

(* What is proved; Not_verified where a claim does not hold *)
let check certificate read_case budget =
  let form =
    match certificate with
    | Object found -> (
      match List.assoc_opt "certificate" found with Some (Text form) -> form | _ -> "")
    | _ -> ""
  in
  let told = List.map (fun said : proved -> { said; theorem = None }) in
  match form with
  | "certificate-v1" -> check_plane ~has_axes:false certificate read_case budget
  | "axes-certificate-v1" -> check_plane ~has_axes:true certificate read_case budget
  | "convex-certificate-v1" -> told (Bodies.check certificate read_case budget)
  | "path-certificate-v1" -> told (Paths.check certificate read_case budget)
  | "solid-certificate-v1" | "solid-point-certificate-v1" ->
    fail Declined "there is no theorem about sums of any polyhedra yet"
  | "feature-certificate-v1" -> fail Declined "there is no theorem about bridges yet"
  | "union-certificate-v1" -> fail Declined "there is no theorem about unions yet"
  | "disc-sum-certificate-v1" -> fail Declined "there is no theorem about sums with a disc yet"
  | _ -> fail Malformed "there is no such form of certificates"
