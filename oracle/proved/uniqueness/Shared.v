(** Rings that bound one component and run together somewhere have the same edges; from their least
    vertices they are the same lists. *)
From Coq Require Import Lra Lia Psatz Permutation Classical.
From Proved Require Import Definitions Form Sums Crossings Fans Curves Unions Local Across Overlaps
  Differing Components.
From Proved Require Import OneForm Paths Decomposed Gaps Unique Boundaries Beside Rounds
  Next.
Open Scope R_scope.

Lemma path_reach {A} (P : A -> Prop) : forall rest first previous x,
  (forall e f, In (e, f) (path first previous rest) -> P e -> P f) -> In x (previous :: rest) ->
  P x -> P first.
Proof.
  induction rest as [|n rest IH]; intros first p x H I K.
  - destruct I as [<-|[]]. apply (H p); simpl; auto.
  - assert (G : forall e f, In (e, f) (path first n rest) -> P e -> P f)
      by (intros e f J; apply H; simpl; auto).
    destruct I as [<-|I]; [|exact (IH first n x G I K)].
    apply (IH first n n G); simpl; auto. apply (H p); simpl; auto.
Qed.
Lemma path_all {A} (P : A -> Prop) : forall rest first previous,
  (forall e f, In (e, f) (path first previous rest) -> P e -> P f) -> P previous ->
  forall x, In x (previous :: rest) -> P x.
Proof.
  induction rest as [|n rest IH]; intros first p H K x [<-|I]; auto; [destruct I|].
  apply (IH first n); auto.
  - intros e f J. apply H. simpl. auto.
  - apply (H p); simpl; auto.
Qed.
(** A property that goes from each entry to the next, and from the last to the first *)
Lemma ring_all {A} (P : A -> Prop) (L : list A) y :
  (forall e f, In (e, f) (ring_edges L) -> P e -> P f) -> In y L -> P y ->
  forall x, In x L -> P x.
Proof.
  destruct L as [|a L]; [intros _ []|]. simpl ring_edges. intros H I K.
  apply (path_all P L a a H). exact (path_reach P L a a y H I K).
Qed.

Lemma ring_starts (R : list point) : map fst (ring_edges R) = R.
Proof. destruct R as [|a R]; auto. apply (path_closed R a a). Qed.
Lemma ring_vertices R : is_ring R -> NoDup R.
Proof.
  intros Rg. rewrite <- (ring_starts R).
  apply (Permutation_NoDup (Permutation_sym (ring_closed R))).
  assert (L : forall e, In e (ring_edges R) -> fst e <> snd e) by (intros; eapply ring_long; eauto).
  destruct Rg as (P & _). induction P as [|e E F P IH]; simpl; constructor.
  - rewrite in_map_iff. intros (f & Q & I). rewrite Forall_forall in F. apply (F f I (snd e)).
    + split; [apply on_segment_end|]. apply not_eq_sym, L. simpl. auto.
    + rewrite <- Q. split; [apply on_segment_end|]. apply not_eq_sym, L. simpl. auto.
  - apply IH. intros f I. apply L. simpl. auto.
Qed.
Lemma one_end {A B} (E : list (A * B)) x y z : NoDup (map fst E) -> In (x, y) E ->
  In (x, z) E -> y = z.
Proof.
  induction E as [|[a b] E IH]; simpl; [tauto|]. intros N. inversion N; subst.
  assert (No : forall w, ~ In (a, w) E) by (intros w I; apply H1, in_map_iff; exists (a, w); auto).
  intros [Q|I] [Q'|I']; auto.
  - congruence.
  - injection Q; intros; subst. destruct (No _ I').
  - injection Q'; intros; subst. destruct (No _ I).
Qed.
Lemma paths_equal {A} : forall (l k : list A) first previous,
  (forall x y z, In (x, y) (path first previous l) -> In (x, z) (path first previous k) -> y = z) ->
  ~ In first l -> ~ In first k -> l = k.
Proof.
  induction l as [|a l IH]; intros [|b k] first p H L K; auto.
  - destruct K. simpl. left. symmetry. apply (H p); simpl; auto.
  - destruct L. simpl. left. apply (H p); simpl; auto.
  - assert (a = b) by (apply (H p); simpl; auto). subst. f_equal. apply (IH k first b).
    + intros x y z I J. apply (H x); simpl; auto.
    + simpl in L. tauto.
    + simpl in K. tauto.
Qed.

Lemma before_not p : ~ before p p.
Proof. intros [H|[_ H]]; lra. Qed.
Lemma least_first R Q : NoDup Q -> starts_least R -> starts_least Q ->
  (forall e, In e (ring_edges R) <-> In e (ring_edges Q)) -> R = Q.
Proof.
  intros N LR LQ H. pose proof N as N'. rewrite <- (ring_starts Q) in N'.
  assert (V : forall p, In p R <-> In p Q).
  { intros p. rewrite <- (ring_starts R), <- (ring_starts Q), !in_map_iff.
    split; intros (e & Q1 & Q2); exists e; split; auto; apply H, Q2. }
  destruct R as [|a R], Q as [|b Q]; try (destruct LR; fail); try (destruct LQ; fail).
  simpl in LR, LQ. assert (a = b).
  { destruct (proj1 (V a) (or_introl eq_refl)) as [E|E]; auto.
    destruct (proj2 (V b) (or_introl eq_refl)) as [F|F]; auto.
    destruct (before_not a). exact (before_transitive _ _ _ (LR b F) (LQ a E)). }
  subst b. f_equal. apply (paths_equal R Q a a).
  - intros x y z I J. apply (one_end (ring_edges (a :: Q)) x); auto. apply H. exact I.
  - intros I. exact (before_not a (LR a I)).
  - intros I. exact (before_not a (LQ a I)).
Qed.

Lemma together_self e : together e e.
Proof. exists 0, 1. rewrite at_0, at_1. repeat split; lra. Qed.
Lemma edges_shared S C E R Q e f : is_part S C E -> bounds S C R -> bounds S C Q ->
  In e (ring_edges R) -> In f (ring_edges Q) -> together e f ->
  forall g, In g (ring_edges R) <-> In g (ring_edges Q).
Proof.
  intros Pt BR BQ Ie If T. destruct (ring_next _ _ Ie) as (e' & Je).
  destruct (ring_next _ _ If) as (f' & Jf).
  pose proof (same_next S C E Pt R Q e e' f f' BR BQ Je Jf T) as <-.
  assert (Ke : In e' (ring_edges R)) by apply (around R e e' (proj1 BR) Je).
  assert (Kf : In e' (ring_edges Q)) by apply (around Q f e' (proj1 BQ) Jf).
  assert (One : forall A B, bounds S C A -> bounds S C B -> In e' (ring_edges A) ->
    In e' (ring_edges B) -> forall g, In g (ring_edges A) -> In g (ring_edges B)).
  { intros A B BA BB IA IB. apply (ring_all (fun g => In g (ring_edges B)) _ e'); auto.
    intros x y Ix Kx. destruct (ring_next _ _ Kx) as (z & Iz).
    rewrite (same_next S C E Pt A B x y x z BA BB Ix Iz (together_self x)).
    apply (around B x z (proj1 BB) Iz). }
  intros g. split; apply One; auto.
Qed.
