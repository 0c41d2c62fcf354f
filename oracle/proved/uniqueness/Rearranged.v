(** Two forms of one closed set are the same polygons but for the order, and where rings start. *)
From Coq Require Import Lra Lia Psatz Permutation Classical.
From Proved Require Import Definitions Form Moving Crossings Local Components Canonical.
From Proved Require Import OneForm Paths Decomposed Gaps Unique Boundaries Beside Rounds Next
  Shared Under Turned.
Open Scope R_scope.

(** ** Rings with the same edges *)
Lemma same_edges_turned (R Q : list point) : NoDup R -> NoDup Q ->
  (forall e, In e (ring_edges R) <-> In e (ring_edges Q)) -> turned R Q.
Proof.
  intros NR NQ H. destruct R as [|a R].
  { destruct Q as [|q Q]; [exists [], []; auto|]. exfalso. pose proof (ring_starts (q :: Q)) as E.
    destruct (ring_edges (q :: Q)) as [|e L]; [discriminate|].
    apply (proj2 (H e) (or_introl eq_refl)). }
  assert (I : In a Q).
  { pose proof (ring_starts (a :: R)) as E.
    destruct (ring_edges (a :: R)) as [|e L] eqn:El; [discriminate|]. injection E; intros E1 E2.
    rewrite <- (ring_starts Q), <- E2. apply in_map, H. simpl. auto. }
  apply in_split in I. destruct I as (l & k & ->).
  assert (T : turned (l ++ a :: k) ((a :: k) ++ l)) by (exists l, (a :: k); auto).
  pose proof (turned_permuted _ _ T) as Pm. pose proof (turned_permuted _ _ (turned_edges _ _ T)) as
    Pe.
  pose proof (Permutation_NoDup Pm NQ) as N'. simpl in N'. inversion N'; subst.
  inversion NR; subst. exists (a :: k), l. split; auto.
  change ((a :: k) ++ l) with (a :: (k ++ l)). f_equal.
  apply (paths_equal R (k ++ l) a a); auto. intros x y z J K.
  apply (one_end (ring_edges (l ++ a :: k)) x).
  - rewrite ring_starts. auto.
  - apply H. exact J.
  - apply (Permutation_in _ (Permutation_sym Pe)). exact K.
Qed.
Lemma area_turned (R Q : list point) : turned R Q -> area R = area Q.
Proof.
  intros T. unfold area. pose proof (turned_permuted _ _ (turned_edges _ _ T)) as P. clear T.
  induction P; simpl; lra.
Qed.

(** ** Rings of a form have no edge in common. *)
Lemma pairs_app {A} (T : A -> A -> Prop) l k : ForallOrdPairs T (l ++ k) ->
  ForallOrdPairs T k /\ forall x y, In x l -> In y k -> T x y.
Proof.
  induction l as [|a l IH]; simpl; intros P; [split; [auto|intros x y []]|].
  inversion P as [|? ? F P' Q]; subst. destruct (IH P') as (H & G). split; auto.
  rewrite Forall_forall in F. intros x y [<-|I] J; auto. apply F, in_or_app. auto.
Qed.
Lemma pairs_flat {A B} (T : B -> B -> Prop) (f : A -> list B) l :
  ForallOrdPairs T (flat_map f l) ->
  ForallOrdPairs (fun a b => forall x y, In x (f a) -> In y (f b) -> T x y) l.
Proof.
  induction l as [|a l IH]; simpl; intros P; [constructor|].
  destruct (pairs_app T _ _ P) as (H & G).
  constructor; auto. rewrite Forall_forall. intros b I x y X Y. apply G; auto.
  apply in_flat_map. exists b. auto.
Qed.
Lemma pairs_imply {A} (T U : A -> A -> Prop) l : (forall x y, In x l -> In y l -> T x y -> U x y) ->
  ForallOrdPairs T l -> ForallOrdPairs U l.
Proof.
  intros H P. induction P as [|a l F P IH]; constructor.
  - rewrite Forall_forall in *. intros x I. apply H; simpl; auto.
  - apply IH. intros x y I J. apply H; simpl; auto.
Qed.
Definition no_shared (R Q : list point) : Prop :=
  forall e, In e (ring_edges R) -> In e (ring_edges Q) -> False.
Lemma rings_apart S ps : is_form S ps -> ForallOrdPairs no_shared (rings_of ps).
Proof.
  intros FP. pose proof FP as (C & _ & _ & F & _). unfold all_edges in F. apply pairs_flat in F.
  revert F. apply pairs_imply. intros R Q IR IQ H [a b] I J.
  assert (In (a, b) (form_edges ps)) by (apply in_flat_map; exists R; auto).
  destruct (in_form S ps a b FP H0) as (_ & _ & _ & N). apply N.
  apply (H (a, b) (a, b) I J); cbn [fst snd]; auto using on_segment_start, on_segment_end.
Qed.

(** ** Polygons, and holes, are paired. *)
Lemma turned_shared (R R' Q : list point) : turned R Q -> turned R' Q -> area Q <> 0 ->
  no_shared R R' -> False.
Proof.
  intros T T' A N.
  destruct (ring_edges Q) as [|e E] eqn:L; [apply A; unfold area; rewrite L; auto|].
  apply (N e); eapply Permutation_in; try (apply Permutation_sym, turned_permuted, turned_edges;
    eassumption); rewrite L; simpl; auto.
Qed.
Lemma turned_back {A} (l k : list A) : turned l k -> turned k l.
Proof. intros (a & b & -> & ->). exists b, a. auto. Qed.
Section Two.
Variable S : point -> Prop.
Variables ps qs : list (polygon point).
Hypothesis is_closed_set : is_closed S.
Hypothesis FP : is_form S ps.
Hypothesis FQ : is_form S qs.

Lemma holes_apart ms outer holes : is_form S ms -> In (outer, holes) ms ->
  ForallOrdPairs no_shared holes.
Proof.
  intros F I. apply in_split in I. destruct I as (l & k & ->). pose proof (rings_apart S _ F) as P.
  unfold rings_of in P. rewrite flat_map_app in P. simpl in P.
  apply pairs_app in P. destruct P as (P & _). inversion P as [|? ? _ P' Q]; subst.
  rewrite <- (app_nil_l (holes ++ _)) in P'. exact (pairs_of_part _ [] holes _ P').
Qed.
Lemma polygons_paired C D i j outer holes outer' holes' : parts S ps C -> parts S qs D ->
  nth_error ps i = Some (outer, holes) -> nth_error qs j = Some (outer', holes') ->
  (forall x, C i x <-> D j x) -> same_polygon (outer, holes) (outer', holes').
Proof.
  intros PC PD N N' Same.
  assert (To : forall R, In R (outer :: holes) -> exists Q, In Q (outer' :: holes') /\ turned R Q).
  { intros R I. destruct (ring_meets S ps qs C D i j outer holes outer' holes' R) as (Q & J & H);
      auto. exists Q. split; auto. destruct PC as (_ & _ & B), PD as (_ & _ & B').
    apply same_edges_turned; auto; apply ring_vertices;
      [apply (B i _ _ N)|apply (B' j _ _ N')]; auto. }
  assert (Fro : forall Q, In Q (outer' :: holes') -> exists R, In R (outer :: holes) /\ turned R Q).
  { intros Q I. destruct (ring_meets S qs ps D C j i outer' holes' outer holes Q) as (R & J & H);
      auto; [intros x; symmetry; apply Same|]. exists R. split; auto.
    destruct PC as (_ & _ & B), PD as (_ & _ & B').
    apply same_edges_turned; [| |intros e; symmetry; apply H]; apply ring_vertices;
      [apply (B i _ _ N)|apply (B' j _ _ N')]; auto. }
  destruct PC as (_ & _ & HC), PD as (_ & _ & HD).
  destruct (HC i _ _ N) as (A & Ah & _). destruct (HD j _ _ N') as (A' & Ah' & _). split.
  - destruct (To outer (or_introl eq_refl)) as (Q & [<-|J] & T); [exact T|].
    apply area_turned in T. specialize (Ah' Q J). lra.
  - cbn [snd]. apply (pairs_match turned).
    + intros Q J. destruct (Fro Q (or_intror J)) as (R & [<-|I] & T); [|eauto].
      apply area_turned in T. specialize (Ah' Q J). lra.
    + intros R I. destruct (To R (or_intror I)) as (Q & [<-|J] & T); [|eauto].
      apply area_turned in T. specialize (Ah R I). lra.
    + apply (pairs_imply no_shared); [|exact (holes_apart ps outer holes FP (nth_error_In _ _ N))].
      intros R R' I I' H Q T T'. apply (turned_shared R R' Q T T'); auto.
      rewrite <- (area_turned _ _ T). specialize (Ah R I). lra.
    + apply (pairs_imply no_shared);
        [|exact (holes_apart qs outer' holes' FQ (nth_error_In _ _ N'))].
      intros Q Q' J J' H R T T'. apply (turned_shared Q Q' R); auto using turned_back.
      rewrite (area_turned _ _ T). specialize (Ah' Q J). lra.
Qed.
Lemma outers_apart ms : is_form S ms -> ForallOrdPairs (fun p q => no_shared (fst p) (fst q)) ms.
Proof.
  intros F. pose proof (rings_apart S ms F) as P. apply pairs_flat in P. revert P.
  apply pairs_imply. intros p q _ _ H. apply H; simpl; auto.
Qed.
Lemma forms_paired : paired same_polygon ps qs.
Proof.
  destruct (form_parts S ps is_closed_set FP) as (C & PC).
  destruct (form_parts S qs is_closed_set FQ) as (D & PD).
  assert (Area : forall p, In p ps -> area (fst p) <> 0).
  { intros [o h] I. destruct (In_nth_error _ _ I) as (i & N). destruct PC as (_ & _ & H).
    destruct (H i o h N). simpl. lra. }
  assert (Area' : forall q, In q qs -> area (fst q) <> 0).
  { intros [o h] I. destruct (In_nth_error _ _ I) as (i & N). destruct PD as (_ & _ & H).
    destruct (H i o h N). simpl. lra. }
  apply pairs_match.
  - intros [o' h'] J. destruct (In_nth_error _ _ J) as (j & N').
    assert (Lj : (j < length qs)%nat) by (apply nth_error_Some; congruence).
    destruct (components_unique _ _ _ _ _ (proj1 PD) (proj1 PC) j Lj) as (i & Li & Same).
    destruct (nth_error ps i) as [[o h]|] eqn:N; [|apply nth_error_Some in Li; congruence].
    exists (o, h). split; [exact (nth_error_In _ _ N)|].
    apply (polygons_paired C D i j); auto. intros x. symmetry. apply Same.
  - intros [o h] I. destruct (In_nth_error _ _ I) as (i & N).
    assert (Li : (i < length ps)%nat) by (apply nth_error_Some; congruence).
    destruct (components_unique _ _ _ _ _ (proj1 PC) (proj1 PD) i Li) as (j & Lj & Same).
    destruct (nth_error qs j) as [[o' h']|] eqn:N'; [|apply nth_error_Some in Lj; congruence].
    exists (o', h'). split; [exact (nth_error_In _ _ N')|].
    apply (polygons_paired C D i j); auto.
  - apply (pairs_imply (fun p q => no_shared (fst p) (fst q))); [|apply outers_apart, FP].
    intros p p' I I' H q (T & _) (T' & _). apply (turned_shared _ _ _ T T'); auto.
    rewrite <- (area_turned _ _ T). auto.
  - apply (pairs_imply (fun p q => no_shared (fst p) (fst q))); [|apply outers_apart, FQ].
    intros q q' I I' H p (T & _) (T' & _).
    apply (turned_shared (fst q) (fst q') (fst p)); auto using turned_back.
    rewrite (area_turned _ _ T). auto.
Qed.
End Two.
Theorem one_form_but_for_order_holds : one_form_but_for_order.
Proof. intros S ps qs Cl FP FQ. exact (forms_paired S ps qs Cl FP FQ). Qed.
