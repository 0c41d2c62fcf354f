(** Claims `hit` and `valid` of docs/certificates-paths.md: points that the part and the obstacles
    share, at places that move with the scale; and scales that follow each other. *)
From Coq Require Import Lra Lia Psatz Bool.
From Proved Require Import Definitions Predicates Ways Sums Crossings Fans Curves Unions Local
  Numbers Rational Values Checker Corners Cancellation Bodies Scaling Trees Theorems Components
  Clear Bounds Free.
Open Scope R_scope.
#[local] Existing Instance Clear.anywhere.

(** ** The programs *)
(** A body as half-planes: the points p with n p + h not negative *)
Definition half_plane := (corner * number)%type.
Definition turned_left (d : corner) : corner := (nminus zero (snd d), fst d).
Definition from_point (n a : corner) : half_plane := (n, nminus zero (qdot n a)).
Definition across (n a b : corner) : list half_plane := [from_point n a; from_point (opposite n) b].
Definition half_planes (l : list corner) : list half_plane :=
  match l with
  | [a] => across (one, zero) a a ++ across (zero, one) a a
  | [a; b] =>
      if distinct a b then across (qminus b a) a b ++ across (turned_left (qminus b a)) a b
      else across (one, zero) a a ++ across (zero, one) a a
  | _ => map (fun e => from_point (turned_left (qminus (snd e) (fst e))) (fst e)) (ring_edges l)
  end.

(** At all of the scales i, the place x and the shared point y move: y is in b, y - x in s a. *)
Definition shares (c : touch) (i : scales) (a b : list corner) (x y : moving_place) : bool :=
  let z := (qminus (fst y) (fst x), qminus (snd y) (snd x)) in
  (negb (is_allowed c) || is_polygon a && is_polygon b) &&
  forallb (fun l => is_positive_on i (is_allowed c) (qdot (fst l) (snd y))
    (nplus (qdot (fst l) (fst y)) (snd l))) (half_planes b) &&
  forallb (fun l => is_positive_on i (is_allowed c) (nplus (qdot (fst l) (snd z)) (snd l))
    (qdot (fst l) (fst z))) (half_planes a).
Definition solids_share (c : touch) (i : scales) (of_r of_o : tiled) (ab : nat * nat)
    (x y : moving_place) : bool :=
  match nth_error (solids of_r) (fst ab), nth_error (solids of_o) (snd ab) with
  | Some a, Some b => shares c i (fst a) (fst b) x y
  | _, _ => false
  end.

(** The scales of i are each in one of the list, which is in order. *)
Definition starts_by (i first : scales) : bool :=
  less (low first) (low i) || Qle_bool (low first) 0 ||
  (Qeq_bool (low first) (low i) && (low_in first || negb (low_in i))).
Definition is_void (i : scales) : bool :=
  match high i with
  | None => false
  | Some b => less b (low i) || (Qeq_bool b (low i) && negb (low_in i && high_in i))
  end.
(** What is left of i after the scales up to b *)
Definition after (b : Q) (b_in : bool) (i : scales) : scales :=
  if less b (low i) then i
  else {| low := b; high := high i;
          low_in := (if Qeq_bool b (low i) then low_in i else true) && negb b_in;
          high_in := high_in i |}.
Fixpoint covers (i : scales) (l : list scales) : bool :=
  is_void i ||
  match l with
  | [] => false
  | first :: more =>
      starts_by i first &&
      match high first with None => true | Some b => covers (after b (high_in first) i) more end
  end.

(** A hit: scales, a segment, how far along it, and the shared point *)
Record hit := { hit_scales : scales; segment : nat; along_start : number; along_speed : number;
  nodes : nat * nat; shared : moving_place }.
Definition place_of (p q : corner) (h : hit) : moving_place :=
  let d := qminus q p in
  (qadd p (ntimes (along_start h) (fst d), ntimes (along_start h) (snd d)),
   (ntimes (along_speed h) (fst d), ntimes (along_speed h) (snd d))).
Definition is_one_hit (c : touch) (path : list corner) (of_r of_o : tiled) (h : hit) : bool :=
  match nth_error (segments_of path) (segment h) with
  | None => false
  | Some (p, q) =>
      is_positive_on (hit_scales h) false (along_speed h) (along_start h) &&
      is_positive_on (hit_scales h) false (nminus zero (along_speed h))
        (nminus one (along_start h)) &&
      solids_share c (hit_scales h) of_r of_o (nodes h) (place_of p q h) (shared h)
  end.
Definition check_hit (c : touch) (i : scales) (r o : rings vertex) (path : list vertex)
    (of_r of_o : tiled) (hits : list hit) : bool :=
  check_sides c (fixed_rings r) (fixed_rings o) of_r of_o &&
  covers i (map hit_scales hits) &&
  forallb (is_one_hit c (map fixed path) of_r of_o) hits.

(** Claims whose scales follow each other: the scales of those that say yes are those of a list. *)
Definition follow_each_other (i : scales) (l : list scales) (claims : list (scales * bool))
    : bool :=
  let yes := map fst (filter snd claims) in
  covers i (map fst claims) &&
  forallb (fun v => covers v [i] && covers v yes) l && forallb (fun v => covers v l) yes.
Inductive way_claim := Is_free (legs : list (leg * list step)) | Is_hit (hits : list hit).
Definition says_free (w : way_claim) : bool := match w with Is_free _ => true | _ => false end.
Definition check_way (c : touch) (r o : rings vertex) (path : list vertex) (of_r of_o : tiled)
    (w : scales * way_claim) : bool :=
  match snd w with
  | Is_free legs => check_free c (fst w) r o path of_r of_o legs
  | Is_hit hits => check_hit c (fst w) r o path of_r of_o hits
  end.
Definition check_valid (c : touch) (i : scales) (l : list scales) (r o : rings vertex)
    (path : list vertex) (of_r of_o : tiled) (claims : list (scales * way_claim)) : bool :=
  match path with [] => false | _ => true end &&
  follow_each_other i l (map (fun w => (fst w, says_free (snd w))) claims) &&
  forallb (check_way c r o path of_r of_o) claims.
