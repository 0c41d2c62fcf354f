(** Classes of cells are components: of the inner points of the set, or of what is outside. *)
From Coq Require Import Lra Lia Psatz Bool QArith Qreals ZArith Sorted Classical.
From Proved Require Import Definitions Form Crossings Local Across Overlaps Components OneForm Paths
  Decomposed Gaps Unique Beside.
From Proved Require Import Points Member Pieces Slabs Sorting Along Cuts Lone Flanks Frontier Stacks
  Slabbed Cells Parted Disjoint.
Open Scope R_scope.

Lemma between_lists (L H : list R) : (forall l h, In l L -> In h H -> l < h) ->
  exists y, (forall l, In l L -> l < y) /\ (forall h, In h H -> y < h).
Proof.
  intros K.
  assert (Low : L <> [] -> exists m, In m L /\ forall l, In l L -> l <= m).
  { clear K. induction L as [|l L IH]; intros N; [contradiction|].
    destruct L as [|k L]; [exists l; split; [simpl; auto|]; intros j [<-|[]]; lra|].
    destruct IH as (m & M & G); [discriminate|]. destruct (Rle_dec l m) as [Le|Gt].
    - exists m. split; [right; auto|]. intros j [<-|J]; auto.
    - exists l. split; [left; auto|]. intros j [<-|J]; [lra|]. specialize (G j J). lra. }
  assert (Up : forall m, (forall h, In h H -> m < h) -> exists y, m < y /\ forall h, In h H ->
    y < h).
  { clear K Low. intros m. induction H as [|h H IH]; intros G; [exists (m + 1); split; [lra|];
      intros h []|].
    destruct IH as (y & Y & F); [intros; apply G; simpl; auto|].
    pose proof (G h (or_introl eq_refl)).
    exists (Rmin y ((m + h) / 2)). split; [apply Rmin_glb_lt; lra|].
    pose proof (Rmin_l y ((m + h) / 2)). pose proof (Rmin_r y ((m + h) / 2)).
    intros k [<-|I]; [lra|]. specialize (F k I). lra. }
  destruct L as [|l L].
  - assert (Any : exists y : R, forall h, In h H -> y < h).
    { clear. induction H as [|h H (y & Y)]; [exists 0; intros h []|].
      exists (Rmin y (h - 1)). pose proof (Rmin_l y (h - 1)). pose proof (Rmin_r y (h - 1)).
      intros k [<-|I]; [lra|]. specialize (Y k I). lra. }
    destruct Any as (y & Y). exists y. split; [intros l []|exact Y].
  - destruct Low as (m & M & G); [discriminate|]. destruct (Up m) as (y & Y & F); [auto|].
    exists y. split; auto. intros k I. specialize (G k I). lra.
Qed.

Section Together.
Variable B : list edge.
Hypothesis alike : forall e f x, In e B -> In f B -> inside e x -> inside f x ->
  forall y, lies_on e y -> lies_on f y.
Let cells := concat (slabs B).
Hypothesis centre : forall c, In c cells -> exists z, within_cell c z.
Variable U : point -> Prop.
Variable b : bool.
Hypothesis U_open : forall x, U x -> interior U x.
Hypothesis U_told : forall c y, In c cells -> within_cell c y -> (U y <-> full c = b).
Hypothesis U_in : forall x, U x -> exists c, In c cells /\ full c = b /\ in_cell c x.
Hypothesis U_clear : forall x, U x -> ~ over_some B x.
Hypothesis U_wall : forall m r, 0 < r -> (forall y, near r m y -> fst y <> fst m -> U y) -> U m.

(** ** Cells near a point of U *)
Definition ranged (c : cell) (x : point) : Prop :=
  (forall q, from c = Some q -> Q2R q < fst x) /\ (forall q, to c = Some q -> fst x < Q2R q).
Lemma cell_edges c e : In c cells -> bottom c = Some e \/ top c = Some e -> slopes e /\ In e B /\
  forall x, ranged c x -> lies_on e (fst x, height_of e (fst x)).
Proof.
  intros I H. destruct (cell_where B c I) as [(x0 & x1 & A & J)|(Eb & Et & _)].
  2: { destruct H as [H|H]; congruence. }
  destruct (slab_cell B x0 x1 A c J) as ((F & T) & P & Q & _).
  assert (O : over_slab B x0 x1 e) by (destruct H; auto). destruct O as (Ie & Ne & He).
  split; [exact Ne|split; [exact Ie|]]. intros x (R0 & R1). apply inside_on, He.
  split; [apply R0, F|apply R1, T].
Qed.
Lemma fills c x r y z : In c cells -> (forall p, near r x p -> U p) -> near r x y ->
  within_cell c y -> near r x z -> ranged c z -> within_cell c z.
Proof.
  intros I Ball Y Wy Z Rz.
  assert (G : forall e, bottom c = Some e \/ top c = Some e -> forall t, 0 <= t <= 1 ->
    level e (at_ y z t) <> 0).
  { intros e He t T E. destruct (cell_edges c e I He) as (Ne & Ie & On).
    assert (P : near r x (at_ y z t)) by (apply (near_between r x y z); auto; apply at_on, T).
    apply (U_clear _ (Ball _ P)). exists e. split; auto.
    assert (Rp : ranged c (at_ y z t)).
    { destruct Wy as (A & D & _), Rz as (A' & D'). unfold at_. split; cbn [fst snd].
      - intros q Eq. specialize (A q Eq). specialize (A' q Eq). 
        pose proof (mean_positive (fst y - Q2R q) (fst z - Q2R q) t). lra.
      - intros q Eq. specialize (D q Eq). specialize (D' q Eq).
        pose proof (mean_positive (Q2R q - fst y) (Q2R q - fst z) t). lra. }
    specialize (On _ Rp). destruct (level_height e (at_ y z t) Ne) as (k & K & Lh).
    rewrite E in Lh. assert (Hs : snd (at_ y z t) = height_of e (fst (at_ y z t))) by nra.
    rewrite <- Hs in On. rewrite <- surjective_pairing in On. exact On. }
  assert (Zero : forall u v, 0 < u -> v <= 0 -> exists t, 0 <= t <= 1 /\ (1 - t) * u + t * v = 0).
  { intros u v Hu Hv. exists (u / (u - v)).
    assert (K : u / (u - v) * (u - v) = u) by (field; lra). set (k := u / (u - v)) in *.
    clearbody k. split; [split; apply Rnot_lt_le; intros L; nra|]. lra. }
  destruct Wy as (A & D & F & H), Rz as (A' & D'). repeat split; auto.
  - intros e E. specialize (F e E). apply Rnot_le_lt. intros L.
    destruct (Zero (level e y) (level e z) F L) as (t & T & K).
    apply (G e (or_introl E) t T). rewrite level_segment. exact K.
  - intros e E. specialize (H e E). apply Rnot_le_lt. intros L.
    destruct (Zero (- level e y) (- level e z)) as (t & T & K); [lra|lra|].
    apply (G e (or_intror E) t T). rewrite level_segment. lra.
Qed.
Lemma within_near c x r : In c cells -> in_cell c x -> 0 < r -> exists y, near r x y /\
  within_cell c y.
Proof.
  intros I X R. destruct (centre c I) as (z & Z). destruct (at_near x z 0 r R) as (d & Hd & K).
  rewrite at_0 in K. set (t := Rmin 1 (d / 2)). assert (T : 0 < t <= 1 /\ t < d).
  { unfold t. pose proof (Rmin_l 1 (d / 2)). pose proof (Rmin_r 1 (d / 2)).
    assert (0 < Rmin 1 (d / 2)) by (apply Rmin_glb_lt; lra). lra. }
  exists (at_ x z t). split; [|apply toward_inside; tauto].
  apply K. rewrite Rminus_0_r, Rabs_right; lra.
Qed.
Lemma beside_in c x r h : In c cells -> in_cell c x -> 0 < r -> (forall p, near r x p -> U p) ->
  Rabs h < r -> in_cell c (fst x, snd x + h).
Proof.
  intros I X R Ball H. apply in_cell_closed. intros e He.
  destruct (within_near c x (Rmin e r) I X) as (y & Y & W); [apply Rmin_glb_lt; auto|].
  apply near_min in Y. destruct Y as [Y1 Y2]. exists (fst y, snd x + h). split.
  - split; cbn [fst snd]; [apply Y1|]. rewrite Rminus_diag_eq, Rabs_R0; auto.
  - apply within_in. apply (fills c x r y); auto.
    + split; cbn [fst snd]; [apply Y2|]. replace (snd x + h - snd x) with h by ring. exact H.
    + destruct W as (A & D & _). split; auto.
Qed.
Lemma ranged_near c x : ranged c x -> exists s, 0 < s /\ forall y, near s x y -> ranged c y.
Proof.
  intros (A & D).
  assert (G : exists s, 0 < s /\ forall y, near s x y -> forall q, from c = Some q ->
    Q2R q < fst y).
  { destruct (from c) as [q|]; [|exists 1; split; [lra|discriminate]].
    specialize (A q eq_refl). exists (fst x - Q2R q). split; [lra|].
    intros y [Y _] p E. injection E; intros <-. apply Rabs_def2 in Y. lra. }
  assert (H : exists s, 0 < s /\ forall y, near s x y -> forall q, to c = Some q -> fst y < Q2R q).
  { destruct (to c) as [q|]; [|exists 1; split; [lra|discriminate]].
    specialize (D q eq_refl). exists (Q2R q - fst x). split; [lra|].
    intros y [Y _] p E. injection E; intros <-. apply Rabs_def2 in Y. lra. }
  destruct G as (s & Hs & G), H as (t & Ht & H). exists (Rmin s t).
  split; [apply Rmin_glb_lt; auto|]. intros y Y. apply near_min in Y.
    split; [apply G|apply H]; tauto.
Qed.
(** Where a point of a cell is that is not between its walls *)
Lemma at_wall c x : In c cells -> in_cell c x -> ranged c x \/
  (exists q, to c = Some q /\ Q2R q = fst x /\ forall p, from c = Some p -> Q2R p < fst x) \/
  (exists q, from c = Some q /\ Q2R q = fst x /\ forall p, to c = Some p -> fst x < Q2R p).
Proof.
  intros I (A & D & _). destruct (centre c I) as (z & (A' & D' & _)). unfold ranged.
  destruct (from c) as [p|], (to c) as [q|].
  - specialize (A p eq_refl). specialize (D q eq_refl). specialize (A' p eq_refl).
    specialize (D' q eq_refl).
    destruct (Req_dec (Q2R p) (fst x)) as [E|E]; [|destruct (Req_dec (Q2R q) (fst x)) as [E'|E']].
    + right; right. exists p. split; auto. split; auto. intros r Er. injection Er; intros <-. lra.
    + right; left. exists q. split; auto. split; auto. intros r Er. injection Er; intros <-. lra.
    + left. split; intros r Er; injection Er; intros <-; lra.
  - specialize (A p eq_refl). destruct (Req_dec (Q2R p) (fst x)) as [E|E].
    + right; right. exists p. split; auto. split; auto. discriminate.
    + left. split; [|discriminate]. intros r Er; injection Er; intros <-; lra.
  - specialize (D q eq_refl). destruct (Req_dec (Q2R q) (fst x)) as [E|E].
    + right; left. exists q. split; auto. split; auto. discriminate.
    + left. split; [discriminate|]. intros r Er; injection Er; intros <-; lra.
  - left. split; discriminate.
Qed.

(** Two cells that meet in a point of U overlap or are linked. *)
Lemma common_in c d x r y : In c cells -> In d cells -> (forall p, near r x p -> U p) ->
  0 < r -> in_cell c x -> near r x y -> ranged c y -> within_cell d y ->
  exists z, within_cell c z /\ within_cell d z.
Proof.
  intros I J Ball R X Y Ry W. exists y. split; auto.
  destruct (within_near c x r I X R) as (z & Z & Wz). apply (fills c x r z y); auto.
Qed.
Lemma below_near c d x r p : In c cells -> In d cells -> (forall y, near r x y -> U y) -> 0 < r ->
  in_cell c x -> in_cell d x -> Q2R p = fst x -> is_below p c d = true.
Proof.
  intros I J Ball R X Y P. unfold is_below. destruct (bottom c) as [e|] eqn:E; auto.
  destruct (top d) as [f|] eqn:F; auto.
  destruct (cell_edges c e I (or_introl E)) as (Ne & _).
  destruct (cell_edges d f J (or_intror F)) as (Nf & _).
  apply less_real. rewrite !height_real, P by auto.
  assert (H1 : Rabs (- (r / 2)) < r) by (rewrite Rabs_Ropp, Rabs_right; lra).
  assert (H2 : Rabs (r / 2) < r) by (rewrite Rabs_right; lra).
  destruct (beside_in c x r _ I X R Ball H1) as (_ & _ & L & _). specialize (L e E).
  destruct (beside_in d x r _ J Y R Ball H2) as (_ & _ & _ & M). specialize (M f F).
  destruct (level_sign e (fst x, snd x + - (r / 2)) Ne) as [_ Le].
  destruct (level_sign f (fst x, snd x + r / 2) Nf) as [Lf _]. cbn [fst snd] in Le, Lf.
  assert (~ (snd x + - (r / 2) < height_of e (fst x))) by (rewrite <- Le; lra).
  assert (~ (height_of f (fst x) < snd x + r / 2)) by (rewrite <- Lf; lra). lra.
Qed.
Theorem meeting_cells c d x : U x -> In c cells -> In d cells -> in_cell c x -> in_cell d x ->
  (exists y, within_cell c y /\ within_cell d y) \/ linked c d = true.
Proof.
  intros Ux I J X Y. destruct (U_open x Ux) as (r & R & Ball).
  assert (Left : forall c d, In c cells -> In d cells -> in_cell c x -> in_cell d x ->
    (exists q, to c = Some q /\ Q2R q = fst x /\ forall p, from c = Some p -> Q2R p < fst x) ->
    (exists q, from d = Some q /\ Q2R q = fst x /\ forall p, to d = Some p -> fst x < Q2R p) ->
    linked c d = true).
  { clear c d I J X Y. intros c d I J X Y (p & T & P & _) (q & F & Q & _).
    unfold linked. apply orb_true_iff. left. unfold is_left_of. rewrite T, F, !andb_true_iff.
    split; [split; [split; [split|]|]|]; try (apply (below_near _ _ x r); auto).
    apply equal_real. congruence. }
  assert (One : forall c d, In c cells -> In d cells -> in_cell c x -> in_cell d x ->
    (exists s, 0 < s /\ forall y, near s x y -> within_cell d y -> ranged c y) ->
    exists y, within_cell c y /\ within_cell d y).
  { clear c d I J X Y. intros c d I J X Y (s & Hs & K).
    destruct (within_near d x (Rmin r s) J Y) as (y & Ny & W); [apply Rmin_glb_lt; auto|].
    apply near_min in Ny. apply (common_in c d x r y); auto; [tauto|]. apply K; tauto. }
  destruct (at_wall c x I X) as [Rc|[Tc|Fc]].
  { left. apply One; auto. destruct (ranged_near c x Rc) as (s & Hs & K). eauto. }
  - destruct (at_wall d x J Y) as [Rd|[Td|Fd]].
    + left. destruct (One d c J I Y X) as (y & W1 & W2); [|eauto].
      destruct (ranged_near d x Rd) as (s & Hs & K). eauto.
    + left. apply One; auto. destruct Tc as (q & T & Q & F), Td as (p & T' & P & _).
      assert (G : exists s, 0 < s /\ forall w, from c = Some w -> s <= fst x - Q2R w).
      { destruct (from c) as [w|]; [|exists 1; split; [lra|discriminate]].
        specialize (F w eq_refl). exists (fst x - Q2R w). split; [lra|].
        intros v E. injection E; intros <-. lra. }
      destruct G as (s & Hs & G). exists s. split; auto. intros y [Ny _] W. apply Rabs_def2 in Ny.
      split; intros w E.
      * specialize (G w E). lra.
      * rewrite T in E. injection E; intros <-. destruct W as (_ & D & _). specialize (D p T'). lra.
    + right. apply Left; auto.
  - destruct (at_wall d x J Y) as [Rd|[Td|Fd]].
    + left. destruct (One d c J I Y X) as (y & W1 & W2); [|eauto].
      destruct (ranged_near d x Rd) as (s & Hs & K). eauto.
    + right. rewrite linked_back. apply Left; auto.
    + left. apply One; auto. destruct Fc as (q & T & Q & F), Fd as (p & T' & P & _).
      assert (G : exists s, 0 < s /\ forall w, to c = Some w -> s <= Q2R w - fst x).
      { destruct (to c) as [w|]; [|exists 1; split; [lra|discriminate]].
        specialize (F w eq_refl). exists (Q2R w - fst x). split; [lra|].
        intros v E. injection E; intros <-. lra. }
      destruct G as (s & Hs & G). exists s. split; auto. intros y [Ny _] W. apply Rabs_def2 in Ny.
      split; intros w E.
      * rewrite T in E. injection E; intros <-. destruct W as (D & _). specialize (D p T'). lra.
      * specialize (G w E). lra.
Qed.
End Together.
