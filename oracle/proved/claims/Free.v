(** Claim `free` of docs/certificates-paths.md: pieces that are held apart do not collide, nor do
    the part and the obstacles. *)
From Coq Require Import Lra Lia Psatz Bool.
From Proved Require Import Definitions Predicates Ways Sums Crossings Fans Curves Unions Local
  Numbers Rational Values Checker Corners Cancellation Bodies Scaling Trees Theorems Components
  Clear Bounds.
Open Scope R_scope.
#[local] Existing Instance Clear.anywhere.

(** ** Pieces that are held apart do not collide. *)
Lemma one_positive : 0 < value one.
Proof. rewrite value_one. lra. Qed.
Lemma set_leaves r o x : check_operand one r o = true ->
  (set_of (outline r) x <-> exists l, In l (leaves (root o)) /\ body l x).
Proof.
  intros H. rewrite (operand_is_leaves one r o one_positive H x).
  split; intros (l & I & B); exists l; split; auto; rewrite scale_one in *; exact B.
Qed.
Lemma near_add e x y z : near e y z -> near e (add x y) (add x z).
Proof.
  intros [A B]. unfold near, add; cbn [fst snd]. split.
  - replace (fst x + fst z - (fst x + fst y)) with (fst z - fst y) by ring. exact A.
  - replace (snd x + snd z - (snd x + snd y)) with (snd z - snd y) by ring. exact B.
Qed.
Lemma held_apart_free c s r o of_r of_o x : 0 < s -> check_sides c r o of_r of_o = true ->
  (forall la lb, In la (leaves (root of_r)) -> In lb (leaves (root of_o)) ->
    held_apart c s x la lb) -> free c s (outline r) (outline o) x.
Proof.
  intros S H A. unfold check_sides in H. rewrite !andb_true_iff in H. destruct H as [[Hr Ho] T].
  assert (Below : forall n lb m q, In lb (leaves (root of_o)) ->
    (forall v, In v lb -> dot n (real v) <= m) -> body lb q -> dot n q <= m).
  { intros n lb m q I B K. apply (body_le lb); auto.
    apply (leaves_are_bodies _ (operand_tree _ _ _ Ho) lb I). }
  destruct c; intros K.
  - destruct K as (z & (e0 & He0 & N0) & e & He & N). simpl in T. apply negb_true_iff in T.
    apply orb_false_iff in T. destruct T as [Tr _].
    destruct (N0 z (near_self e0 z He0)) as (u & Hu & E).
    apply (set_leaves r of_r u Hr) in Hu. destruct Hu as (la & Ia & Ka).
    pose proof (fat_leaves _ _ _ Hr Tr la Ia) as Oa.
    pose proof Ka as Kt. rewrite polygon_body in Kt by auto.
    destruct Kt as (a1 & a2 & a3 & It & Kt).
    pose proof (polygon_positive _ Oa _ _ _ It) as D.
    set (d := minus (middle a1 a2 a3) u).
    destruct (soon_exists _ (soon_and _ _ (curve_inside a1 a2 a3 u D Kt)
      (curve_near (e / s) u d (Rdiv_lt_0_compat _ _ He S)))) as (t & _ & In1 & Near).
    fold d in In1. set (u' := curve u d t) in *.
    assert (Q' : set_of (outline o) (add x (scale s u'))).
    { apply N. rewrite E. apply near_add, near_scale; auto. }
    apply (set_leaves o of_o _ Ho) in Q'. destruct Q' as (lb & Ib & Kb).
    destruct (A la lb Ia Ib) as (n & ma & mb & Nz & Ma & Mb & M).
    specialize (Below n lb mb _ Ib Mb Kb).
    assert (K1 : - dot n u' < ma).
    { set (m := (- fst n, - snd n)).
      assert (Em : forall y, dot m y = - dot n y) by (intros; unfold dot, m; cbn [fst snd]; ring).
      rewrite <- Em. pose proof (triangle_corners _ _ _ _ It)
        as (v1 & v2 & v3 & J1 & J2 & J3 & E1 & E2 & E3).
      apply (triangle_lt m ma a1 a2 a3 u' D In1); [|rewrite Em, E1|rewrite Em, E2|rewrite Em, E3];
        auto. intros [Z1 Z2]. apply Nz. unfold m in *; cbn [fst snd] in *. lra. }
    assert (K2 : dot n (add x (scale s u')) = dot n x + s * dot n u')
      by (unfold dot, add, scale; cbn [fst snd]; ring). nra.
  - destruct K as (z & (u & Hu & ->) & Q').
    apply (set_leaves r of_r u Hr) in Hu. destruct Hu as (la & Ia & Ka).
    apply (set_leaves o of_o _ Ho) in Q'. destruct Q' as (lb & Ib & Kb).
    destruct (A la lb Ia Ib) as (n & ma & mb & Nz & Ma & Mb & M).
    specialize (Below n lb mb _ Ib Mb Kb).
    assert (K1 : - ma <= dot n u).
    { apply (body_ge la); auto; [apply (leaves_are_bodies _ (operand_tree _ _ _ Hr) la Ia)|].
      intros v V. specialize (Ma v V). lra. }
    assert (K2 : dot n (add x (scale s u)) = dot n x + s * dot n u)
      by (unfold dot, add, scale; cbn [fst snd]; ring). nra.
Qed.
Lemma empty_free c s r o x : is_empty r || is_empty o = true ->
  free c s (outline r) (outline o) x.
Proof.
  intros E. apply orb_prop in E.
  assert (None_ : forall (k : rings corner) y, is_empty k = true -> ~ set_of (outline k) y)
    by (intros [|? ?] y K; [apply empty_set|discriminate]).
  destruct c; intros (z & K1 & K2).
  - destruct K1 as (e & He & K1). destruct (K1 z (near_self e z He)) as (u & Hu & _).
    destruct K2 as (f & Hf & K2). specialize (K2 z (near_self f z Hf)).
    destruct E as [E|E]; eapply None_; eauto.
  - destruct K1 as (u & Hu & _). destruct E as [E|E]; eapply None_; eauto.
Qed.

(** ** Ways *)
Theorem clear_holds c i r o of_r of_o places legs s :
  check_clear c i r o of_r of_o places legs = true -> in_scales i s ->
  places <> [] /\ forall p q, In (p, q) (segments_of places) -> forall x,
    on_segment (place_at s p) (place_at s q) x -> free c s (outline r) (outline o) x.
Proof.
  unfold check_clear. intros H Si. apply andb_prop in H. destruct H as [Ne H].
  split; [intros ->; discriminate|]. intros p q I x X.
  destruct (is_empty r || is_empty o) eqn:Em; [apply empty_free, Em|].
  cbn [orb] in H. apply andb_prop in H. destruct H as [Sides H].
  destruct (all2_partner _ _ _ H (p, q) I) as ([l code] & L). unfold check_leg in L.
  rewrite !andb_true_iff in L. destruct L as [[[E0 E1] Pos] F].
  apply same_real in E0. apply same_real in E1.
  destruct (positive_on _ _ _ _ s Pos Si) as [D _]. destruct X as (u & U & X).
  set (t := u * (value (growth l) * s + value (length_ l))).
  assert (Ex : x = next_to p (direction l) t s).
  { rewrite X. unfold place_at, next_to, place_at, add, scale. rewrite E0, E1.
    unfold real, qadd; cbn [fst snd]. rewrite !value_plus, !value_times. unfold t. f_equal; ring. }
  apply (held_apart_free c s r o of_r of_o x (proj1 Si) Sides). intros la lb Ia Ib. rewrite Ex.
  unfold check_sides in Sides. rewrite !andb_true_iff in Sides. destruct Sides as [[Hr Ho] _].
  apply (ways_held_apart c p (direction l) t s la lb code _ F) with
    (cell := starting_cell i l) (a := root of_r) (b := root of_o); simpl; auto.
  - intros e [<-|[]]. simpl. split; eapply operand_tree; eauto.
  - assert (T0 : 0 <= t) by (apply Rmult_le_pos; lra).
    assert (T1 : t <= value (growth l) * s + value (length_ l)) by (unfold t; nra).
    intros b [<-|[<-|J]].
    + unfold holds_at, worth_at; cbn [of_t of_s rest is_strict]. rewrite value_one, value_zero. lra.
    + unfold holds_at, worth_at; cbn [of_t of_s rest is_strict value].
      replace (Q2R (-1)) with (-1) by (unfold Q2R; simpl; lra). lra.
    + apply (bounds_hold i s t Si b J).
Qed.
Lemma segments_of_map {A B} (f : A -> B) l : segments_of (map f l) = map (both f) (segments_of l).
Proof.
  destruct l as [|a [|b r]]; try reflexivity. unfold segments_of. cbn [map]. revert a b.
  induction r as [|c r IH]; intros a b; [reflexivity|]. cbn [map segments] in *. f_equal. apply IH.
Qed.
Lemma place_stays s v : place_at s (stays v) = point_of v.
Proof.
  unfold place_at, stays, add, scale, real, fixed, point_of; cbn [fst snd value].
  rewrite value_zero. f_equal; ring.
Qed.
Theorem free_is_right : forall (c : touch) (i : scales) (r o : rings vertex) (path : list vertex)
    (of_r of_o : tiled) (legs : list (leg * list step)),
  check_free c i r o path of_r of_o legs = true -> is_free c r o path i.
Proof.
  intros c i r o path of_r of_o legs H. unfold check_free in H.
  assert (Ne : path <> []) by (intros ->; discriminate). split; auto.
  intros s Si x (a & b & I & X). destruct (clear_holds _ _ _ _ _ _ _ _ s H Si) as [_ K].
  rewrite !outline_fixed in K. rewrite segments_of_map in I. apply in_map_iff in I.
  destruct I as ([v w] & E & I). injection E; intros <- <-. unfold free_at.
  apply (K (stays v) (stays w)).
  - rewrite segments_of_map. apply in_map_iff. exists (v, w). auto.
  - rewrite !place_stays. exact X.
Qed.
