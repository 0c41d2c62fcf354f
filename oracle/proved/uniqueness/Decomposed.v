(** A sum is a union: the translates of each operand by the vertices of the other, and the
  parallelograms of
    their edges. No piece of an operand is needed. *)
From Coq Require Import Lra Lia Psatz Permutation Classical.
From Proved Require Import Definitions Sums Crossings Fans Curves Unions Local Across Overlaps
  Components.
From Proved Require Import Paths.
Open Scope R_scope.

Definition edges_t := list (point * point).
Definition closed (E : edges_t) := Permutation (map fst E) (map snd E).
Definition on_some (E : edges_t) (p : point) := exists a b, In (a, b) E /\ on_segment a b p.
Definition has_edges (E : edges_t) := forall p, on_some E p -> region E p.

Lemma off_all E p : ~ on_some E p -> forall a b, In (a, b) E -> ~ on_segment a b p.
Proof. intros N a b I O. apply N. exists a, b. auto. Qed.
Lemma winding_here E p : closed E -> ~ on_some E p ->
  exists e, 0 < e /\ forall q, near e p q -> winding E q = winding E p.
Proof. intros C N. apply winding_near; auto. apply off_all, N. Qed.
Lemma region_off E p : closed E -> ~ on_some E p -> region E p <-> (0 < winding E p)%Z.
Proof.
  intros C N. destruct (winding_here E p C N) as (e & He & K). split.
  - intros H. destruct (H e He) as (q & Q & _ & W). rewrite <- (K q Q). exact W.
  - intros W d D. exists p. split; [apply near_self; auto|split; auto]. apply off_all, N.
Qed.
Lemma region_closed E p : (forall e, 0 < e -> exists q, near e p q /\ region E q) -> region E p.
Proof.
  intros H e E0. destruct (H (e / 2) ltac:(lra)) as (q & Q & R).
  destruct (R (e / 2) ltac:(lra)) as (y & Y & O & W). exists y. split; auto.
  exact (near_near e p q y Q Y).
Qed.

(** Above all vertices nothing is wound around. *)
Lemma crossing_above a b y : snd a < snd y -> snd b < snd y -> crossing a b y = 0%Z.
Proof.
  intros A B. unfold crossing, orient. split_decisions; auto; exfalso; nra.
Qed.
Lemma winding_above E : exists h, forall y, h < snd y -> winding E y = 0%Z.
Proof.
  induction E as [|[a b] E (h & H)]; [exists 0; reflexivity|].
  exists (Rmax h (Rmax (snd a) (snd b))). intros y Y.
  pose proof (Rmax_l h (Rmax (snd a) (snd b))). pose proof (Rmax_r h (Rmax (snd a) (snd b))).
  pose proof (Rmax_l (snd a) (snd b)). pose proof (Rmax_r (snd a) (snd b)).
  change (winding ((a, b) :: E) y) with (crossing a b y + winding E y)%Z.
  rewrite H, crossing_above by lra. reflexivity.
Qed.
Lemma region_below E : exists h, forall y, region E y -> snd y <= h.
Proof.
  destruct (winding_above E) as (h & H). exists h. intros y R.
  destruct (Rle_dec (snd y) h) as [|L]; auto. exfalso.
  destruct (R (snd y - h) ltac:(lra)) as (q & [_ Q] & _ & W). rewrite (H q) in W; [lia|].
  apply Rabs_def2 in Q. lra.
Qed.

Definition minus_ (x p : point) : point := (fst x - fst p, snd x - snd p).
Lemma near_minus e x p q : near e p q -> near e (minus_ x p) (minus_ x q).
Proof.
  unfold near, minus_; cbn [fst snd]. intros [A B]. split.
  - replace (fst x - fst q - (fst x - fst p)) with (- (fst q - fst p)) by ring. rewrite Rabs_Ropp.
    auto.
  - replace (snd x - snd q - (snd x - snd p)) with (- (snd q - snd p)) by ring. rewrite Rabs_Ropp.
    auto.
Qed.
Lemma add_minus x p : x = add p (minus_ x p).
Proof. unfold add, minus_; destruct x; simpl; f_equal; ring. Qed.
Lemma minus_minus x p : minus_ x (minus_ x p) = p.
Proof. unfold minus_; destruct p; simpl; f_equal; ring. Qed.

(** Along an edge that meets no edge of F, seen from x, all is in F's set or nothing. *)
Lemma along_edge F a b x p : closed F -> (forall q, on_segment a b q -> ~ on_some F (minus_ x q)) ->
  on_segment a b p -> region F (minus_ x p) -> region F (minus_ x a).
Proof.
  intros C N O R. assert (A : on_segment a b a) by (exists 0; split; [lra|destruct a; simpl;
    f_equal; ring]).
  apply region_off; auto. apply region_off in R; auto.
  rewrite <- (constant_on_segment (fun q => winding F (minus_ x q)) p a); auto.
  intros q Q. assert (Oq : on_segment a b q).
  { destruct O as (t & T & ->). destruct Q as (u & U & ->). exists ((1 - u) * t). split; [nra|].
    cbn [fst snd]. f_equal; ring. }
  destruct (winding_here F (minus_ x q) C (N q Oq)) as (e & He & K). exists e. split; auto.
  intros z Z. apply K, near_minus, Z.
Qed.

Section Sum.
Variables E F : edges_t.
Hypothesis E_closed : closed E.
Hypothesis F_closed : closed F.
Hypothesis E_in : has_edges E.
Hypothesis F_in : has_edges F.

Definition by_vertex_of_E x := exists a b, In (a, b) E /\ region F (minus_ x a).
Definition by_vertex_of_F x := exists c d, In (c, d) F /\ region E (minus_ x c).
Definition by_edges x := exists p q, on_some E p /\ on_some F q /\ x = add p q.

Theorem sum_is_union x : (exists p q, region E p /\ region F q /\ x = add p q) <->
  by_vertex_of_E x \/ by_vertex_of_F x \/ by_edges x.
Proof.
  split.
  2: { intros [(a & b & I & R)|[(c & d & I & R)|(p & q & P & Q & ->)]].
    - exists a, (minus_ x a). split; [|split; [exact R|apply add_minus]]. apply E_in. exists a, b.
      split; auto. exists 0. split; [lra|destruct a; simpl; f_equal; ring].
    - exists (minus_ x c), c. split; [exact R|split]; [apply F_in; exists c, d; split; auto|].
      + exists 0. split; [lra|destruct c; simpl; f_equal; ring].
      + unfold add, minus_; destruct x; simpl; f_equal; ring.
    - exists p, q. auto. }
  intros (p & q & P & Q & X).
  destruct (classic (by_edges x)) as [B|B]; [auto|].
  assert (Apart : forall z, on_some E z -> ~ on_some F (minus_ x z)).
  { intros z Z1 Z2. apply B. exists z, (minus_ x z). split; auto. split; auto. apply add_minus. }
  (* up from p, as far as it goes *)
  set (up := fun t : R => (fst p, snd p + t)).
  set (U := fun t => 0 <= t /\ region E (up t) /\ region F (minus_ x (up t))).
  destruct (region_below E) as (h & H).
  assert (U0 : U 0).
  { split; [lra|]. replace (up 0) with p by (unfold up; destruct p; simpl; f_equal; ring).
    split; auto. rewrite X. replace (minus_ (add p q) p) with q; auto.
    unfold minus_, add; destruct q; simpl; f_equal; ring. }
  destruct (completeness U) as (m & Up & Least).
  { exists (h - snd p). intros t (_ & R & _). apply H in R. unfold up in R. simpl in R. lra. }
  { exists 0. exact U0. }
  assert (M0 : 0 <= m) by (apply Up, U0).
  assert (Close : forall e, 0 < e -> exists t, U t /\ m - e < t <= m).
  { intros e He. apply NNPP. intros N. assert (m <= m - e); [|lra]. apply Least. intros t T.
    pose proof (Up t T). destruct (Rle_dec t (m - e)); auto. exfalso. apply N. exists t. split;
      auto. lra. }
  assert (NU : forall t e, m - e < t <= m -> 0 < e -> near e (up m) (up t)).
  { intros t e T He. unfold near, up; simpl. rewrite Rminus_diag_eq, Rabs_R0 by auto. split; auto.
    apply Rabs_def1; lra. }
  assert (RE : region E (up m)).
  { apply region_closed. intros e He. destruct (Close e He) as (t & (_ & A & _) & T). exists (up
    t). auto. }
  assert (RF : region F (minus_ x (up m))).
  { apply region_closed. intros e He. destruct (Close e He) as (t & (_ & _ & A) & T).
    exists (minus_ x (up t)). split; auto. apply near_minus; auto. }
  destruct (classic (on_some E (up m))) as [OE|OE].
  { left. destruct OE as (a & b & I & O). exists a, b. split; auto.
    apply (along_edge F a b x (up m)); auto. intros z Z. apply Apart. exists a, b. auto. }
  destruct (classic (on_some F (minus_ x (up m)))) as [OF|OF].
  { right; left. destruct OF as (c & d & I & O). exists c, d. split; auto.
    apply (along_edge E c d x (minus_ x (up m))); auto.
    - intros z Z G. apply (Apart _ G). rewrite minus_minus. exists c, d. auto.
    - rewrite minus_minus. exact RE. }
  exfalso. destruct (winding_here E _ E_closed OE) as (e & He & KE).
  destruct (winding_here F _ F_closed OF) as (f & Hf & KF).
  apply region_off in RE; auto. apply region_off in RF; auto.
  set (d := Rmin e f / 2). assert (D : 0 < d /\ d < e /\ d < f).
  { unfold d. pose proof (Rmin_l e f). pose proof (Rmin_r e f).
    assert (0 < Rmin e f) by (apply Rmin_glb_lt; auto). lra. }
  assert (ND : forall g, d < g -> near g (up m) (up (m + d))).
  { intros g G. unfold near, up; simpl. rewrite Rminus_diag_eq, Rabs_R0 by auto. split; [lra|].
    apply Rabs_def1; lra. }
  assert (G : U (m + d)).
  { split; [lra|]. split.
    - apply region_closed. intros g Hg.
      (* near up (m+d) the winding number is the same: it lies within the neighbourhood of up m *)
      exists (up (m + d)). split; [apply near_self; auto|]. intros k Hk.
      destruct (classic (on_some E (up (m + d)))) as [O|O].
      + apply E_in; auto.
      + exists (up (m + d)). split; [apply near_self; auto|]. split; [apply off_all, O|].
        rewrite KE; [exact RE|]. apply ND; lra.
    - intros k Hk. destruct (classic (on_some F (minus_ x (up (m + d))))) as [O|O].
      + apply F_in; auto.
      + exists (minus_ x (up (m + d))). split; [apply near_self; auto|]. split; [apply off_all, O|].
        rewrite KF; [exact RF|]. apply near_minus, ND; lra. }
  apply Up in G. lra.
Qed.
End Sum.
