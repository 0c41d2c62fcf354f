(** Sets that are combined: off all edges the program tells the closure of the interior, which
    begins and ends on edges alone. *)
From Coq Require Import Lra Lia Bool QArith Qreals ZArith Classical.
From Proved Require Import Definitions Form Legality Operations Local Across Components OneForm
  Paths Decomposed Gaps Unique Convolution.
From Proved Require Import Points Legal Member Decided Pieces Along Cuts Flanks Frontier Extent
  Reduced Arranged Traced Combined.
Open Scope R_scope.

(** Close to any point is one that is on no edge. *)
Lemma some_off (E : edges_t) x r : 0 < r -> exists y, near r x y /\ ~ on_some E y.
Proof.
  revert r. induction E as [|[a b] E IH]; intros r Hr.
  - exists x. split; [apply near_self, Hr|]. intros (a & b & [] & _).
  - destruct (IH (r / 2) ltac:(lra)) as (y & Y & N).
    destruct (classic (on_segment a b y)) as [O|O].
    + destruct (edges_near E y N) as (e & He & Off).
      assert (G : exists c, a <> c /\ forall z, on_segment a b z -> orient a c z = 0).
      { destruct (classic (a = b)) as [<-|D].
        - exists (fst a + 1, snd a). split.
          + intros Q. apply (f_equal fst) in Q. cbn [fst] in Q. lra.
          + intros z (t & _ & ->). unfold orient; cbn [fst snd]. ring.
        - exists b. split; auto. intros z (t & _ & ->). unfold orient; cbn [fst snd]. ring. }
      destruct G as (c & D & G).
      destruct (left_close a c y (Rmin e (r / 2)) D (G y O)) as (z & Z & L).
      { apply Rmin_glb_lt; lra. }
      apply near_min in Z. destruct Z as [Z1 Z2]. exists z.
      split; [exact (near_near r x y z Y Z2)|]. intros (p & q & [Q|I] & K).
      * injection Q; intros; subst p q. rewrite (G z K) in L. lra.
      * apply (Off z Z1). exists p, q. auto.
    + exists y. split.
      * apply (near_near r x y y Y), near_self. lra.
      * intros (p & q & [Q|I] & K); [injection Q; intros; subst; auto|]. apply N. exists p, q. auto.
Qed.

(** ** Sets that are what their edges wind around *)
Definition wound (y : point) (E : edges_t) : bool := (0 <? winding E y)%Z.
Section Combined.
Variable o : operation.
Variable E : edges_t.
Variable Fs : list edges_t.
Hypothesis closes : forall G, In G (E :: Fs) -> closed G.
Let said (y : point) : bool := agree o (wound y E) (map (wound y) Fs).
Let off (y : point) : Prop := ~ on_some (concat (E :: Fs)) y.
Let S : point -> Prop := combined o (region E) (map region Fs).

Lemma off_each y : off y -> forall G, In G (E :: Fs) -> ~ on_some G y.
Proof.
  intros N G I (a & b & J & O). apply N. exists a, b. split; auto. apply in_concat. eauto.
Qed.
Lemma wound_off y G : off y -> In G (E :: Fs) -> wound y G = true <-> region G y.
Proof.
  intros N I. unfold wound. rewrite Z.ltb_lt. symmetry. apply region_off; [apply closes, I|].
  apply off_each; auto.
Qed.
Lemma said_off y : off y -> said y = true <-> S y.
Proof.
  intros N. pose proof (wound_off y E N (or_introl eq_refl)) as H.
  assert (Hs : forall F, In F Fs -> wound y F = true <-> region F y)
    by (intros F I; apply wound_off; simpl; auto).
  assert (Some_ : existsb (fun b => b) (map (wound y) Fs) = true <->
    exists T, In T (map region Fs) /\ T y).
  { rewrite existsb_exists. split.
    - intros (b & I & K). apply in_map_iff in I. destruct I as (F & <- & I).
      exists (region F). split; [apply in_map, I|apply Hs; auto].
    - intros (T & I & K). apply in_map_iff in I. destruct I as (F & <- & I).
      exists (wound y F). split; [apply in_map, I|apply Hs; auto]. }
  assert (All_ : forallb (fun b => b) (map (wound y) Fs) = true <->
    forall T, In T (map region Fs) -> T y).
  { rewrite forallb_forall. split.
    - intros K T I. apply in_map_iff in I. destruct I as (F & <- & I).
      apply Hs; auto. apply K, in_map, I.
    - intros K b I. apply in_map_iff in I. destruct I as (F & <- & I).
      apply Hs; auto. apply K, in_map, I. }
  unfold said, S, agree, combined. destruct o.
  - rewrite orb_true_iff, H, Some_. reflexivity.
  - rewrite andb_true_iff, H, All_. reflexivity.
  - rewrite andb_true_iff, H, negb_true_iff, <- not_true_iff_false, Some_. split.
    + intros [K N']. split; auto. intros T I Ty. apply N'. eauto.
    + intros [K N']. split; auto. intros (T & I & Ty). exact (N' T I Ty).
Qed.
(** Off all edges nothing changes. *)
Lemma said_near y : off y -> exists r, 0 < r /\ forall z, near r y z -> off z /\ said z = said y.
Proof.
  intros N. destruct (edges_near _ y N) as (s & Hs & Off).
  destruct (near_all (E :: Fs) (fun G z => winding G z = winding G y) y) as (r & Hr & K).
  { intros G I. apply winding_here; [apply closes, I|apply off_each; auto]. }
  exists (Rmin r s). split; [apply Rmin_glb_lt; auto|]. intros z Z. apply near_min in Z.
  destruct Z as [Z1 Z2]. split; [exact (Off z Z2)|]. unfold said, wound.
  rewrite (K z Z1 E (or_introl eq_refl)). f_equal. apply map_ext_in. intros F I.
  rewrite (K z Z1 F); simpl; auto.
Qed.
Lemma said_inside y : off y -> said y = true -> interior S y.
Proof.
  intros N H. destruct (said_near y N) as (r & Hr & K). exists r. split; auto. intros z Z.
  destruct (K z Z) as [Nz Q]. apply said_off; auto. rewrite Q. exact H.
Qed.
Lemma inside_said y r : interior S y -> 0 < r -> exists z, near r y z /\ off z /\ said z = true.
Proof.
  intros (e & He & K) Hr.
  destruct (some_off (concat (E :: Fs)) y (Rmin e r)) as (z & Z & N); [apply Rmin_glb_lt; auto|].
  apply near_min in Z. destruct Z as [Z1 Z2]. exists z. split; auto. split; auto.
  apply said_off; auto.
Qed.
Lemma regularised_off y : off y -> (said y = true <-> regularised S y).
Proof.
  intros N. split.
  - intros H e He. exists y. split; [apply near_self, He|]. apply said_inside; auto.
  - intros C. destruct (said_near y N) as (r & Hr & K).
    destruct (C (r / 2) ltac:(lra)) as (z & Z & I).
    destruct (inside_said z (r / 2) I ltac:(lra)) as (w & W & Nw & H).
    destruct (K w (near_near r y z w Z W)) as [_ Q]. rewrite <- Q. exact H.
Qed.
Lemma regularised_steady y : off y -> steady (regularised S) y.
Proof.
  intros N. destruct (said_near y N) as (r & Hr & K). exists r. split; auto. intros z Z.
  destruct (K z Z) as [Nz Q]. rewrite <- !regularised_off by auto. rewrite Q. reflexivity.
Qed.
Lemma regularised_in_one x : regularised S x -> exists G, In G (E :: Fs) /\ region G x.
Proof.
  intros C. apply (closed_finite (E :: Fs) region).
  { intros G _ y. apply region_closed. }
  intros e He. destruct (C e He) as (y & Y & (d & Hd & K)).
  exists y. split; auto. pose proof (K y (near_self d y Hd)) as Sy. unfold S, combined in Sy.
  destruct o.
  - destruct Sy as [Sy|(T & I & Sy)]; [exists E; simpl; auto|].
    apply in_map_iff in I. destruct I as (F & <- & I). exists F. simpl. auto.
  - exists E. simpl. tauto.
  - exists E. simpl. tauto.
Qed.
(** A union is closed as it is. *)
Lemma union_regular x : o = unite -> regularised S x <-> S x.
Proof.
  intros U. assert (Some_ : S x <-> exists G, In G (E :: Fs) /\ region G x).
  { unfold S. rewrite U. simpl. split.
    - intros [H|(T & I & H)]; [exists E; auto|].
      apply in_map_iff in I. destruct I as (F & <- & I). exists F. auto.
    - intros (G & [<-|I] & H); auto. right. exists (region G). split; auto. apply in_map, I. }
  split; [intros C; apply Some_, regularised_in_one, C|].
  intros H. apply Some_ in H. destruct H as (G & I & H). intros e He.
  destruct (H (e / 2) ltac:(lra)) as (y & Y & N & W).
  destruct (winding_here G y) as (d & Hd & K); [apply closes, I|intros (a & b & J & O);
    exact (N a b J O)|].
  destruct (some_off (concat (E :: Fs)) y (Rmin d (e / 2))) as (z & Z & Nz).
  { apply Rmin_glb_lt; lra. }
  apply near_min in Z. destruct Z as [Z1 Z2]. exists z.
  split; [exact (near_near e x y z Y Z2)|]. apply said_inside; [exact Nz|].
  assert (V : wound z G = true) by (apply Z.ltb_lt; rewrite (K z Z1); exact W).
  unfold said. rewrite U. simpl. apply orb_true_iff. destruct I as [<-|I]; [auto|right].
  apply existsb_exists. exists (wound z G). split; auto. apply in_map, I.
Qed.
Lemma regularised_bounded : exists low high, forall x, regularised S x -> low <= snd x <= high.
Proof.
  assert (G : exists low high, forall F x, In F (E :: Fs) -> region F x -> low <= snd x <= high).
  { revert closes. generalize (E :: Fs). clear. intros l. induction l as [|F l IH]; intros C.
    - exists 0, 0. intros F x [].
    - destruct IH as (m & h & H); [intros; apply C; simpl; auto|].
      destruct (region_above F (C F (or_introl eq_refl))) as (k & K).
      destruct (region_below F) as (j & J). exists (Rmin m k), (Rmax h j). intros D x I R.
      pose proof (Rmin_l m k). pose proof (Rmin_r m k). pose proof (Rmax_l h j).
      pose proof (Rmax_r h j). destruct I as [<-|I].
      + specialize (K x R). specialize (J x R). lra.
      + specialize (H D x I R). lra. }
  destruct G as (low & high & G). exists low, high. intros x C.
  destruct (regularised_in_one x C) as (F & I & R). exact (G F x I R).
Qed.
Lemma regularised_is_regular : is_regular (regularised S).
Proof.
  split.
  - intros x Lim e He. destruct (Lim (e / 2) ltac:(lra)) as (y & Y & C).
    destruct (C (e / 2) ltac:(lra)) as (z & Z & I). exists z. split; auto.
    exact (near_near e x y z Y Z).
  - intros x r C Hr. destruct (C r Hr) as (y & Y & (e & He & K)). exists y. split; auto.
    exists (e / 2). split; [lra|]. intros z Z d Hd. exists z. split; [apply near_self, Hd|].
    exists (e / 2). split; [lra|]. intros w W. apply K, (near_near e y z w Z W).
Qed.
End Combined.

(** ** The program, for legal polygon sets *)
Section Legal.
Variable o : operation.
Variable P : list (polygon vertex).
Variable others : list (list (polygon vertex)).
Hypothesis legal : forall K, In K (P :: others) -> is_polygon_set (figure K).
Definition points_in (K : list (polygon vertex)) : point -> Prop := set_of (rings_of (figure K)).
Let edges (K : list (polygon vertex)) := all_edges (rings_of K).
Let real (K : list (polygon vertex)) := map R2e (edges K).
Definition combined_here : point -> Prop :=
  regularised (combined o (points_in P) (map points_in others)).

Lemma real_edges K : real K = all_edges (rings_of (figure K)).
Proof. unfold real, edges. rewrite edges_of_points, rings_of_figure. reflexivity. Qed.
Lemma real_closed G : In G (map real (P :: others)) -> closed G.
Proof.
  intros I. apply in_map_iff in I. destruct I as (K & <- & _). rewrite real_edges.
  apply rings_are_closed.
Qed.
Lemma points_wound K x : In K (P :: others) -> points_in K x <-> region (real K) x.
Proof. intros I. rewrite real_edges. apply (polygon_set_area _ (legal K I)). Qed.
Lemma combined_wound x : combined o (region (real P)) (map region (map real others)) x <->
  combined o (points_in P) (map points_in others) x.
Proof.
  pose proof (points_wound P x (or_introl eq_refl)) as H.
  assert (Hs : forall K, In K others -> points_in K x <-> region (real K) x)
    by (intros K I; apply points_wound; simpl; auto).
  rewrite map_map. unfold combined. destruct o; rewrite H.
  - apply or_iff_compat_l. split; intros (T & I & K); apply in_map_iff in I;
      destruct I as (L & <- & I).
    + exists (points_in L). split; [apply in_map, I|apply Hs; auto].
    + exists (region (real L)).
      split; [apply (in_map (fun y => region (real y))), I|apply Hs; auto].
  - apply and_iff_compat_l. split; intros K T I; apply in_map_iff in I;
      destruct I as (L & <- & I); apply Hs; auto.
    + apply K. apply (in_map (fun y => region (real y))), I.
    + apply K. apply in_map, I.
  - apply and_iff_compat_l. split; intros K T I; apply in_map_iff in I;
      destruct I as (L & <- & I); intros Tx; apply Hs in Tx; auto; revert Tx; apply K.
    + apply (in_map (fun y => region (real y))), I.
    + apply in_map, I.
Qed.
Lemma combination_same x : regularised (combined o (region (real P)) (map region (map real others)))
  x <-> combined_here x.
Proof.
  split; intros C e He; destruct (C e He) as (y & Y & I); exists y; (split; [exact Y|]);
    refine (interior_same _ _ y _ I); intros z; [|apply iff_sym]; apply combined_wound.
Qed.
Lemma segments_real x : ~ over_some (all_segments (map edges (P :: others))) x <->
  ~ on_some (concat (map real (P :: others))) x.
Proof.
  apply not_iff_compat. unfold over_some, all_segments, on_some.
  assert (M : concat (map real (P :: others)) = map R2e (concat (map edges (P :: others)))).
  { unfold real. rewrite <- (map_map edges (map R2e)). symmetry. apply concat_map. }
  rewrite M. clear M. split.
  - intros (f & I & O). apply in_map_iff in I. destruct I as (e & <- & I).
    apply (proj1 (from_left_on e x)) in O. exists (R2 (fst e)), (R2 (snd e)).
    split; [apply (in_map R2e) in I; exact I|exact O].
  - intros (a & b & I & O). apply in_map_iff in I. destruct I as (e & Q & I).
    injection Q; intros <- <-. exists (from_left e). split; [apply in_map, I|].
    apply from_left_on. exact O.
Qed.
Lemma decide_real v : decide_combined o (edges P) (map edges others) v =
  agree o (wound (R2 v) (real P)) (map (wound (R2 v)) (map real others)).
Proof.
  unfold decide_combined, winds_around, wound. rewrite winding_real. f_equal. rewrite !map_map.
  apply map_ext. intros K. rewrite winding_real. reflexivity.
Qed.
Theorem combination_is_arranged :
  is_arranged (decide_combined o (edges P) (map edges others))
    (all_segments (map edges (P :: others))) combined_here.
Proof.
  apply (arranged_same _ _ _ _ combination_same).
  assert (C := real_closed). cbn [map] in C.
  split; [apply regularised_is_regular|]. split; [apply regularised_bounded, C|].
  split; [|split].
  - intros e I. apply in_map_iff in I. destruct I as (f & <- & I). apply from_left_forward.
    apply in_concat in I. destruct I as (l & J & I). apply in_map_iff in J.
    destruct J as (K & <- & J). destruct (polygon_set_winds_once _ (legal K J)) as (_ & N & _).
    unfold null. rewrite <- not_true_iff_false, same_real.
    apply (N (R2e f)). rewrite <- real_edges. apply in_map, I.
  - intros x N. apply regularised_steady; [exact C|]. apply segments_real, N.
  - intros v N. rewrite decide_real. apply regularised_off; [exact C|]. apply segments_real, N.
Qed.
Lemma union_as_it_is x : o = unite ->
  combined_here x <-> combined o (points_in P) (map points_in others) x.
Proof.
  intros U. rewrite <- combination_same, <- combined_wound. apply union_regular; auto.
  exact real_closed.
Qed.
End Legal.
