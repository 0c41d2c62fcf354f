(* The extracted checker behind types that are closed: files that are not believed make derivations
   by the functions below alone, so that whatever they hand over is something the theorems speak
   of. Denominators are positive and numbers of things not negative by construction; [fraction] and
   [natural] see to it, and raise Not_verified. *)

type corner
type stretch
type token
type node
type tiled
type cell
type component
type witness
type derivation
type contact
type difference
type change
type code
type way
type hit
type edge
type trap
type path_claim
type place_claim

(* Corners: at one scale, or at both ends of a `move` *)
val corner : (Q.t * Q.t) list -> corner
val origin : corner

(* Rule `pieces`: a piece, or a group of nodes with its hull; the root, and solids as hulls with the
   numbers of their leaves *)
val piece : corner list -> node
val group : corner list -> node list -> node
val tiled : node -> (corner list * int list) list -> tiled

(* Cells with their proofs, and contacts *)
val covered : corner list -> int -> int -> corner list -> cell
val apart : corner list -> token list -> cell
val open_p : token
val open_q : token
val normal : Q.t * Q.t -> token
val is_apart : corner list -> token list -> tiled -> tiled -> bool
val contact : token list -> int -> int -> contact

(* Components, holes, and edges as rows of stretches *)
val component : int -> (int * corner) list -> (corner list * int list) list -> component
val stretch : int -> int -> corner -> stretch
val witness : tiled -> tiled -> corner list -> cell list -> witness

val derivation :
  witness -> component list -> component -> component list -> stretch list list list list ->
  derivation

val holes_in : derivation -> int

(* Where two figures differ, and what changes at an event *)
val of_turn : int -> difference
val of_touching : int -> difference
val another_after : difference -> change
val another_there : difference -> change
val other_numbers : change
val is_of_boundary : change -> bool

(* What things are, to be written down: there is no way back. *)
val shown : derivation -> Checker.derivation
val pieces_shown : tiled -> Checker.tiled
val code_shown : token list -> Checker.token list

(* The claims: whether the proved checker takes them *)
type rational = Q.t * Q.t
type ring = rational list

val sum_holds :
  Q.t -> ring list -> ring list -> rational Reading.polygon list -> derivation -> bool

val point_holds :
  Q.t -> ring list -> ring list -> rational -> rational -> rational -> tiled -> tiled -> int ->
  int -> bool

val outside_holds :
  Q.t -> ring list -> ring list -> rational -> tiled -> tiled -> token list -> bool

(* From the sets alone (verified/Statement.v): whether one is legal; whether points are in sP + Q;
   sP + Q and how many holes; a set and others combined. None: a set is not legal, or there is no
   answer. *)
type set = rational Reading.polygon list
type operation = Checker.operation = Unite | Intersect | Subtract

val is_legal : set -> bool
val decide_points : Q.t -> set -> set -> rational list -> bool list option
val verified_sum : Q.t -> set -> set -> (set * int) option
val is_polygon_set : set -> bool
val verified_combination : operation -> set -> set list -> (set * int) option

(* Vertex i of sP plus vertex j of Q *)
type place = int option * int option
type predicate

val orientation : place -> place -> place -> predicate
val concurrent : place -> place -> place -> place -> place -> place -> predicate
val sign_holds : ring list -> ring list -> predicate -> Q.t -> Q.t -> Z.t -> bool

val passage_holds :
  Q.t -> ring list -> ring list -> derivation -> rational list -> contact list -> bool

(* The state of a sum: polygons, touching points, and how many holes *)
type 'v state = { polygons : 'v Reading.polygon list; touching : 'v list; enclosed : int }

(* What moves between two scales: a derivation of the first `move`, and then in turn of the sum at
   each scale between and of the next `move` *)
type interval = {
  from : Q.t;
  upto : Q.t;
  figure : Reading.mover state;
  first : derivation;
  rest : (Q.t * derivation * derivation) list;
}

val interval_holds : ring list -> ring list -> interval -> bool

val event_holds :
  ring list -> ring list -> interval -> Q.t -> rational state -> derivation -> interval -> change ->
  bool

type mesh = (Q.t * Q.t * Q.t) list * int list list

(* Step `clear`: codes, and segments of places with their code; points that move and are shared;
   rings *)
val open_part : code
val open_obstacles : code
val cut_at : Q.t -> code
val across : Q.t * Q.t -> code
val nothing_left : Q.t list -> code
val way : rational -> Q.t -> Q.t -> code list -> way
val hit : Reading.scales -> int -> Q.t * Q.t -> int * int -> Reading.mover -> hit
val edge : int * int -> (Reading.scales * Reading.mover * Reading.mover) list -> edge
val trap : Q.t -> Reading.mover list -> edge list -> way list -> trap

(* R and O, a path, and the pieces of both *)
type scene = { part : ring list; obstacles : ring list; path : ring; of_r : tiled; of_o : tiled }

val free_holds : Reading.contact -> Reading.scales -> scene -> way list -> bool
val hit_holds : Reading.contact -> Reading.scales -> scene -> hit list -> bool
val is_free : way list -> path_claim
val is_hit : hit list -> path_claim

val valid_holds :
  Reading.contact -> Reading.scales -> Reading.scales list -> scene ->
  (Reading.scales * path_claim) list -> bool

(* The same of a path of one place; false of another one *)
val escapes_holds :
  Reading.contact -> Reading.scales -> scene -> Reading.mover list -> way list -> rational -> bool

val trapped_holds : Reading.contact -> Reading.scales -> scene -> trap -> bool
val gets_away : Reading.mover list -> way list -> rational -> place_claim
val is_kept : trap -> place_claim
val collides : hit list -> place_claim

val trap_holds :
  Reading.contact -> Reading.scales -> Reading.scales list -> scene ->
  (Reading.scales * place_claim) list -> bool

val body_holds : Q.t * Q.t * Q.t -> mesh -> mesh -> mesh -> (int * int) list -> bool
val volume : mesh -> Q.t
