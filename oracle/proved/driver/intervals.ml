(* The claims `interval` and `event`. Trusted: what is said to be proved is what [Checked] was
   asked, of the moving forms of these digests. *)

open Failure
open Json

(* What a claim is about, for an event *)
type sum = {
  scale : Q.t;
  there : Reading.point Checked.state;
  derivation : Checked.derivation;
}

type kind = Boundary | Topology
type shown = Sum of sum | Interval of Checked.interval * string | Event of Q.t * kind | Another

let named = function Boundary -> "boundary" | Topology -> "topology"

let scale_of value =
  let s = number value in
  require (Q.sign s > 0) "a scale is not positive";
  s

let rec ascends compare = function
  | a :: (b :: _ as rest) -> compare a b < 0 && ascends compare rest
  | _ -> true

(* Each ring from its least vertex; holes and polygons in order *)
let is_in_order polygons =
  let starts_least = function
    | [] -> false
    | first :: rest -> List.for_all (fun m -> Reading.compare_movers first m < 0) rest
  in
  let compare_rings = List.compare Reading.compare_movers in
  let rings (p : _ Reading.polygon) = p.outer :: p.holes in
  List.for_all starts_least (Reading.rings_of polygons)
  && List.for_all (fun (p : _ Reading.polygon) -> ascends compare_rings p.holes) polygons
  && ascends (List.compare compare_rings) (List.map rings polygons)

let shown_of (figure : Reading.mover Checked.state) digest =
  Printf.sprintf "the moving form of digest %s, of %d components and %d holes" digest
    (List.length figure.polygons) figure.enclosed

(* The interval that is claimed, and whether it is proved *)
let interval p q region claim =
  match
    members claim [ "claim"; "from"; "to"; "steps"; "components"; "holes"; "digest" ]
  with
  | [ _; from; upto; steps; components; holes; digest ] ->
    let from = scale_of from and upto = scale_of upto in
    let regions = List.map region (items steps) in
    let enclosed = index holes max_int and digest = text digest in
    let figure, first, rest = Moving.interval from upto regions enclosed in
    let figure = { figure with enclosed } and polygons = figure.polygons in
    let found : Checked.interval = { from; upto; figure; first; rest } in
    demand (Reading.digest_of (Reading.movers_text polygons) = digest) "the digest is another";
    demand (is_in_order polygons) "the moving form is not in order";
    demand
      (Z.equal (integer components) (Z.of_int (List.length polygons)))
      "components are others";
    let said =
      Printf.sprintf "from %s to %s without an event of the boundary, %s" (Q.to_string from)
        (Q.to_string upto) (shown_of figure digest)
    in
    (found, digest, said, lazy (Checked.interval_holds p q found))
  | _ -> assert false

(* An event is proved together with the three claims that it is about. *)
let event p q claim_of claim =
  match members claim [ "claim"; "scale"; "kind"; "before"; "at"; "after" ] with
  | [ _; scale; kind; before; there; after ] ->
    let s = scale_of scale and kind = text kind in
    require (List.mem kind [ "boundary"; "topology" ]) "there is no such event";
    let interval value =
      match claim_of value with
      | Interval (found, digest) -> (found, digest)
      | _ -> fail Malformed "a claim is of another kind"
    in
    let low, digest = interval before and high, other = interval after in
    let { scale = here; there; derivation } =
      match claim_of there with
      | Sum found -> found
      | _ -> fail Malformed "a claim is of another kind"
    in
    demand (Q.equal low.upto s && Q.equal here s && Q.equal high.from s) "not at one scale";
    let is_of_boundary = kind = "boundary" in
    (match Moving.change is_of_boundary s low.figure there high.figure with
     | None -> fail Refuted "nothing changes"
     | Some change ->
       demand
         (Checked.is_of_boundary change = is_of_boundary
         && Checked.event_holds p q low s there derivation high change)
         "the proved checker does not take this for a proof");
    let numbers (state : _ Checked.state) = (List.length state.polygons, state.enclosed) in
    let as_many = numbers low.figure = numbers there && numbers there = numbers high.figure in
    ( Printf.sprintf
        "%s at %s, no event of the boundary from %s to it; before it digest %s, after it %s" kind
        (Q.to_string s) (Q.to_string low.from) digest other,
      Event (s, if as_many then Boundary else Topology) )
  | _ -> assert false

(* All events between two scales: intervals and events that are proved, end to end *)
let events claim_of claim =
  match
    members claim
      [ "claim"; "from"; "to"; "intervals"; "events"; "scales"; "kinds"; "components"; "holes" ]
  with
  | [ _; from; upto; intervals; events; scales; kinds; components; holes ] ->
    let from = scale_of from and upto = scale_of upto in
    let interval value =
      match claim_of value with
      | Interval (found, _) -> found
      | _ -> fail Malformed "a claim is of another kind"
    in
    let event value =
      match claim_of value with
      | Event (s, kind) -> (s, kind)
      | _ -> fail Malformed "a claim is of another kind"
    in
    let intervals = List.map interval (items intervals) in
    let events = List.map event (items events) in
    let as_long list other =
      require (List.compare_lengths list other = 0) "a list has not so many"
    in
    require
      (List.length intervals = List.length events + 1)
      "there are not intervals with events between";
    List.iter (as_long events) [ items scales; items kinds ];
    List.iter (as_long intervals) [ items components; items holes ];
    let joints = List.map fst events in
    demand
      (List.for_all2 (fun (i : Checked.interval) s -> Q.equal i.from s) intervals (from :: joints)
      && List.for_all2 (fun (i : Checked.interval) s -> Q.equal i.upto s) intervals
           (joints @ [ upto ]))
      "the intervals do not reach end to end, with events between";
    demand (List.for_all2 (fun s value -> Q.equal s (scale_of value)) joints (items scales))
      "the events are at other scales";
    let is_kind (_, kind) value = match value with Text t -> t = named kind | _ -> false in
    demand (List.for_all2 is_kind events (items kinds)) "an event is of the other kind";
    let count number value (i : Checked.interval) =
      Z.equal (integer value) (Z.of_int (number i.figure))
    in
    let components_of (f : _ Checked.state) = List.length f.polygons in
    demand
      (List.for_all2 (count components_of) (items components) intervals
      && List.for_all2 (count (fun f -> f.enclosed)) (items holes) intervals)
      "components or holes are others";
    let told (s, kind) = named kind ^ " at " ^ Q.to_string s in
    Printf.sprintf "from %s to %s, without both, all of the boundary: %s" (Q.to_string from)
      (Q.to_string upto)
      (if events = [] then "none" else String.concat ", " (List.map told events))
  | _ -> assert false
