(** Claims `escapes`, `trapped` and `trap` of docs/certificates-paths.md. *)
From Coq Require Import Bool.
From Proved Require Import Definitions Predicates Ways Moving Points Numbers Checker Clear
  Collisions.
Open Scope R_scope.

(** ** The programs *)
(** A way that moves, from the place to where f of the last nodes is positive across the normal *)
Definition check_far (c : touch) (i : scales) (r o : rings corner) (of_r of_o : tiled)
    (e : moving_place) (n : corner) : bool :=
  let f := level e (zero, zero) n (root of_r) (root of_o) in
  distinct n (zero, zero) &&
  (is_empty r || is_empty o || is_positive_on i (negb (is_allowed c)) (of_s f) (rest f)).
Definition starts_at (x : vertex) (p : moving_place) : bool :=
  same (fst p) (fixed x) && same (snd p) (zero, zero).
Definition check_escapes (c : touch) (i : scales) (r o : rings vertex) (x : vertex)
    (of_r of_o : tiled) (places : list moving_place) (legs : list (leg * list step)) (n : vertex)
    : bool :=
  starts_at x (hd (stays x) places) &&
  check_clear c i (fixed_rings r) (fixed_rings o) of_r of_o places legs &&
  check_far c i (fixed_rings r) (fixed_rings o) of_r of_o (last places (stays x)) (fixed n).

(** A ring of places that collide: on each edge one pair of solids, and points they share at both
    ends, for scales that follow each other *)
Record edge_hit := { edge_scales : scales; at_start : moving_place; at_end : moving_place }.
Definition moves (m : mover) : moving_place :=
  let '(x0, x1, (y0, y1)) := m in (fixed (x0, y0), fixed (x1, y1)).
Definition check_edge (c : touch) (i : scales) (of_r of_o : tiled) (e : mover * mover)
    (k : (nat * nat) * list edge_hit) : bool :=
  covers i (map edge_scales (snd k)) &&
  forallb (fun h =>
    solids_share c (edge_scales h) of_r of_o (fst k) (moves (fst e)) (at_start h) &&
    solids_share c (edge_scales h) of_r of_o (fst k) (moves (snd e)) (at_end h)) (snd k).
Definition corner_at (s : Q) (m : mover) : vertex :=
  let '(x0, x1, (y0, y1)) := m in (Qred (x0 + s * x1), Qred (y0 + s * y1)).
Record trapping := { some_scale : Q; ring : list mover; edges : list ((nat * nat) * list edge_hit);
  here_free : list (leg * list step) }.
Definition is_among (i : scales) (s : Q) : bool :=
  less 0 s && (less (low i) s || (low_in i && Qeq_bool s (low i))) &&
  match high i with None => true | Some b => less s b || (high_in i && Qeq_bool s b) end.
Definition check_trapped (c : touch) (i : scales) (r o : rings vertex) (x : vertex)
    (of_r of_o : tiled) (t : trapping) : bool :=
  check_sides c (fixed_rings r) (fixed_rings o) of_r of_o &&
  check_free c i r o [x] of_r of_o (here_free t) &&
  all2 (check_edge c i of_r of_o) (ring_edges (ring t)) (edges t) &&
  is_among i (some_scale t) &&
  negb (winding_of (ring_edges (map (corner_at (some_scale t)) (ring t))) x =? 0)%Z.

(** Claims that follow each other *)
Inductive trap_claim :=
| Gets_away (places : list moving_place) (legs : list (leg * list step)) (n : vertex)
| Kept (t : trapping)
| Collides (hits : list hit).
Definition says_kept (w : trap_claim) : bool := match w with Kept _ => true | _ => false end.
Definition check_stay (c : touch) (r o : rings vertex) (x : vertex) (of_r of_o : tiled)
    (w : scales * trap_claim) : bool :=
  match snd w with
  | Gets_away places legs n => check_escapes c (fst w) r o x of_r of_o places legs n
  | Kept t => check_trapped c (fst w) r o x of_r of_o t
  | Collides hits => check_hit c (fst w) r o [x] of_r of_o hits
  end.
Definition check_trap (c : touch) (i : scales) (l : list scales) (r o : rings vertex) (x : vertex)
    (of_r of_o : tiled) (claims : list (scales * trap_claim)) : bool :=
  follow_each_other i l (map (fun w => (fst w, says_kept (snd w))) claims) &&
  forallb (check_stay c r o x of_r of_o) claims.
