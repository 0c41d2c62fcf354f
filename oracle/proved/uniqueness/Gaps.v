(** A way in C from one wedge at v to another, closed over v, parts the gap between them from the
  others:
    what avoids C and v stays on its side. *)
From Coq Require Import Lra Lia Psatz Permutation Classical.
From Proved Require Import Definitions Sums Crossings Fans Curves Unions Local Across Overlaps
  Components.
From Proved Require Import Paths Decomposed.
Open Scope R_scope.

Lemma on_segment_start a b : on_segment a b a.
Proof. exists 0. split; [lra|destruct a; simpl; f_equal; ring]. Qed.
Lemma on_segment_end a b : on_segment a b b.
Proof. exists 1. split; [lra|destruct b; simpl; f_equal; ring]. Qed.
Lemma winding_cons a b E y : winding ((a, b) :: E) y = (crossing a b y + winding E y)%Z.
Proof. reflexivity. Qed.

Lemma triangle_outside a b c y : 0 < orient a b c ->
  ~ (0 <= orient a b y /\ 0 <= orient c a y) -> crossing3 a b c y = 0%Z.
Proof.
  intros O N. destruct (triangle_crossing a b c y O) as ([Z|Z] & K & _); auto.
  destruct N. destruct (K Z) as (H1 & H2 & H3). auto.
Qed.
Lemma triangle_inside a b c y : 0 < orient a b c -> open_triangle a b c y -> crossing3 a b c y =
  1%Z.
Proof. intros O I. destruct (triangle_crossing a b c y O) as (_ & _ & K). auto. Qed.

Section Gap.
Variable C : point -> Prop.
Variables v a b : point.
Hypothesis v_out : ~ C v.
Hypothesis turn : 0 < orient v a b.
Hypothesis to_a : forall p, on_segment v a p -> p <> v -> C p.
Hypothesis to_b : forall p, on_segment v b p -> p <> v -> C p.
Hypothesis way : joined C a b.
Definition outside_it p := p <> v /\ ~ C p.

(** The way, closed over v *)
Lemma the_ring : exists E, closed ((v, a) :: E ++ [(b, v)]) /\
  forall c d p, In (c, d) E -> on_segment c d p -> C p.
Proof.
  destruct (joined_edges C a b way) as (E & H & P). exists E. split; [|exact H].
  unfold closed. simpl. rewrite !map_app. simpl.
  apply Permutation_trans with (v :: b :: map fst E).
  { apply perm_skip, Permutation_sym, Permutation_cons_append. }
  apply Permutation_trans with (v :: a :: map snd E); [apply perm_skip, P|].
  exact (Permutation_cons_append (a :: map snd E) v).
Qed.

(** Near v in the gap the way winds once more than near v out of it. *)
Lemma jump E : closed ((v, a) :: E ++ [(b, v)]) ->
  (forall c d p, In (c, d) E -> on_segment c d p -> C p) -> exists r n, 0 < r /\
  forall y, near r v y ->
    (0 < orient v a y -> 0 < orient v y b -> winding ((v, a) :: E ++ [(b, v)]) y = (n + 1)%Z) /\
    (~ (0 <= orient v a y /\ 0 <= orient v y b) -> winding ((v, a) :: E ++ [(b, v)]) y = n).
Proof.
  intros Cl H. set (h := 1 / 2).
  set (a' := at_ v a h). set (b' := at_ v b h).
  assert (Sa : on_segment v a a') by (apply at_on; unfold h; lra).
  assert (Sb : on_segment b v b') by (apply segment_swap, at_on; unfold h; lra).
  (* the way with its corner at v cut off *)
  set (J := (a', a) :: E ++ [(b, b'); (b', a')]).
  assert (Split : forall y, winding ((v, a) :: E ++ [(b, v)]) y = (winding J y + crossing3 v a' b'
    y)%Z).
  { intros y. unfold J. rewrite !winding_cons.
    assert (A : forall X Y, winding (X ++ Y) y = (winding X y + winding Y y)%Z).
    { intros X Y. unfold winding. induction X as [|e X IH]; simpl; [reflexivity|]. rewrite IH. lia.
      }
    rewrite !A, !winding_cons. unfold crossing3.
    rewrite (crossing_cut v a a' y Sa), (crossing_cut b v b' y Sb), (crossing_reversed a' b' y).
    simpl. lia. }
  assert (ClJ : closed J).
  { unfold closed, J in *. simpl in *. rewrite !map_app in *. simpl in *.
    assert (P : Permutation (b :: map fst E) (a :: map snd E)).
    { apply (Permutation_cons_inv (a := v)).
      apply Permutation_trans with (v :: map fst E ++ [b]);
        [apply perm_skip; rewrite <- Permutation_cons_append; reflexivity|].
      apply (Permutation_trans Cl). apply Permutation_sym.
      exact (Permutation_cons_append (a :: map snd E) v). }
    apply Permutation_trans with (a' :: b' :: b :: map fst E).
    { apply perm_skip. apply Permutation_trans with ((b :: b' :: nil) ++ map fst E);
        [apply Permutation_app_comm|]. simpl. apply perm_swap. }
    apply Permutation_trans with (a' :: b' :: a :: map snd E); [do 2 apply perm_skip; exact P|].
    apply Permutation_trans with (a :: (b' :: a' :: nil) ++ map snd E).
    { simpl. apply Permutation_trans with (b' :: a' :: a :: map snd E); [apply perm_swap|].
      apply Permutation_trans with (b' :: a :: a' :: map snd E); [apply perm_skip, perm_swap|apply
        perm_swap]. }
    apply perm_skip, Permutation_app_comm. }
  assert (Va : v <> a) by (intros Q; unfold orient in turn; rewrite Q in turn; lra).
  assert (Vb : v <> b) by (intros Q; unfold orient in turn; rewrite Q in turn; lra).
  assert (Tr : 0 < orient v a' b').
  { unfold orient, a', b', at_, h in *. cbn [fst snd]. nra. }
  assert (Off : forall c d, In (c, d) J -> ~ on_segment c d v).
  { unfold J. intros c d [Q|I] O.
    - injection Q; intros; subst c d. destruct O as (t & T & O). apply Va.
      unfold a', at_, h in O. destruct v as [v1 v2], a as [a1 a2]. cbn [fst snd] in O.
      injection O; intros. f_equal; nra.
    - apply in_app_or in I. destruct I as [I|[Q|[Q|[]]]].
      + apply v_out, (H c d v I O).
      + injection Q; intros; subst c d. destruct O as (t & T & O). apply Vb.
        unfold b', at_, h in O. destruct v as [v1 v2], b as [b1 b2]. cbn [fst snd] in O.
        injection O; intros. f_equal; nra.
      + injection Q; intros; subst c d. destruct O as (t & T & O).
        assert (Z : orient b' a' v = 0).
        { rewrite O. unfold orient; cbn [fst snd]. ring. }
        assert (W : orient b' a' v = - orient v a' b') by (unfold orient; ring). lra. }
  destruct (winding_near J v ClJ Off) as (r & Hr & K).
  assert (Third : exists r', 0 < r' /\ forall y, near r' v y -> 0 < orient a' b' y).
  { apply near_left. replace (orient a' b' v) with (orient v a' b') by (unfold orient; ring). exact
    Tr. }
  destruct Third as (r' & Hr' & K').
  exists (Rmin r r'), (winding J v). split; [apply Rmin_glb_lt; auto|].
  intros y Y. apply near_min in Y. destruct Y as [Y Y']. specialize (K y Y). specialize (K' y Y').
  assert (Oa : orient v a' y = h * orient v a y) by (unfold orient, a', at_; cbn [fst snd]; ring).
  assert (Ob : orient b' v y = h * orient v y b) by (unfold orient, b', at_; cbn [fst snd]; ring).
  rewrite Split, K. split.
  - intros A B. rewrite triangle_inside; auto. unfold open_triangle. rewrite Oa, Ob.
    unfold h in *. repeat split; lra.
  - intros N. rewrite triangle_outside; [lia|exact Tr|]. rewrite Oa, Ob. intros [A B]. apply N.
    unfold h in *. lra.
Qed.

Lemma constant_outside E y z : closed ((v, a) :: E ++ [(b, v)]) ->
  (forall c d p, In (c, d) E -> on_segment c d p -> C p) -> joined outside_it y z ->
  winding ((v, a) :: E ++ [(b, v)]) y = winding ((v, a) :: E ++ [(b, v)]) z.
Proof.
  intros Cl H J. apply (joined_constant outside_it); auto.
  intros p [P1 P2]. apply winding_near; auto. intros c d I O.
  destruct I as [Q|I]; [injection Q; intros; subst; apply P2, to_a; auto|].
  apply in_app_or in I. destruct I as [I|[Q|[]]]; [apply P2, (H c d p I O)|].
  injection Q; intros; subst. apply P2, to_b; auto. apply segment_swap, O.
Qed.

(** A point of a segment from v, as near to v as one likes *)
Lemma near_start y r : 0 < r -> y <> v -> exists t, 0 < t <= 1 /\ near r v (at_ v y t).
Proof.
  intros R N. destruct (at_near v y 0 r R) as (d & D & K). rewrite at_0 in K.
  exists (Rmin 1 (d / 2)). assert (0 < Rmin 1 (d / 2)) by (apply Rmin_glb_lt; lra).
  pose proof (Rmin_l 1 (d / 2)). pose proof (Rmin_r 1 (d / 2)). split; [lra|].
  apply K. rewrite Rminus_0_r, Rabs_right; lra.
Qed.
Lemma along_ray y t : 0 < t <= 1 -> y <> v -> (forall p, on_segment v y p -> p <> v -> ~ C p) ->
  joined outside_it y (at_ v y t).
Proof.
  intros T N H. apply joined_step. intros p (u & U & ->).
  set (w := at_ v y t). set (k := 1 + u * (t - 1)).
  assert (E : (fst y + u * (fst w - fst y), snd y + u * (snd w - snd y)) = at_ v y k).
  { unfold w, at_, k; cbn [fst snd]. f_equal; ring. }
  rewrite E. assert (K : 0 < k <= 1) by (unfold k; nra).
  assert (X : at_ v y k <> v).
  { intros Q. apply N. unfold at_ in Q. destruct v as [v1 v2], y as [y1 y2]. cbn [fst snd] in Q.
    injection Q; intros. f_equal; nra. }
  split; auto. apply H; auto. apply at_on. lra.
Qed.

Theorem gap_separation y z :
  (forall p, on_segment v y p -> p <> v -> ~ C p) -> (forall p, on_segment v z p -> p <> v -> ~ C
    p) ->
  y <> v -> z <> v ->
  0 < orient v a y -> 0 < orient v y b -> ~ (0 <= orient v a z /\ 0 <= orient v z b) ->
  ~ joined outside_it y z.
Proof.
  intros Hy Hz Ny Nz Y1 Y2 Z J. destruct the_ring as (E & Cl & H).
  destruct (jump E Cl H) as (r & n & R & K).
  destruct (near_start y r R Ny) as (t & T & NT). destruct (near_start z r R Nz) as (u & U & NU).
  pose proof (along_ray y t T Ny Hy) as Jy. pose proof (along_ray z u U Nz Hz) as Jz.
  assert (J' : joined outside_it (at_ v y t) (at_ v z u)).
  { apply joined_join with y; [apply joined_back, Jy|]. apply joined_join with z; auto. }
  apply (constant_outside E) in J'; auto.
  destruct (K _ NT) as [KY _]. destruct (K _ NU) as [_ KZ].
  assert (O1 : forall c q s, orient v c (at_ v q s) = s * orient v c q)
    by (intros; unfold orient, at_; cbn [fst snd]; ring).
  assert (O2 : forall c q s, orient v (at_ v q s) c = s * orient v q c)
    by (intros; unfold orient, at_; cbn [fst snd]; ring).
  rewrite KY in J'; [|rewrite O1; nra|rewrite O2; nra].
  rewrite KZ in J'; [lia|]. rewrite O1, O2. intros [A B]. apply Z. split; nra.
Qed.
End Gap.
