(** What holds for all small t > 0, on the curve x + t d + (t^2, t^3): it meets no line for long,
    and from a point of a closed triangle it goes inside. *)
From Coq Require Import Lra Lia Psatz.
From Proved Require Import Definitions Sums Crossings Fans.

(** For all small t > 0 *)
Definition soon (P : R -> Prop) : Prop := exists t0, 0 < t0 /\ forall t, 0 < t < t0 -> P t.
Lemma soon_and P Q : soon P -> soon Q -> soon (fun t => P t /\ Q t).
Proof.
  intros (s & Hs & P1) (t & Ht & Q1). exists (Rmin s t). split; [apply Rmin_glb_lt; auto|].
  intros u [U1 U2]. split; [apply P1|apply Q1]; split; auto;
  eapply Rlt_le_trans; eauto using Rmin_l, Rmin_r.
Qed.
Lemma soon_imp (P Q : R -> Prop) : (forall t, P t -> Q t) -> soon P -> soon Q.
Proof. intros H (s & Hs & P1). exists s; auto. Qed.
Lemma soon_all {A} (P : A -> R -> Prop) l : (forall a, In a l -> soon (P a)) ->
  soon (fun t => forall a, In a l -> P a t).
Proof.
  induction l as [|a l IH]; intros H.
  - exists 1. split; [lra|]. simpl; tauto.
  - eapply soon_imp; [|apply soon_and; [apply (H a); simpl; auto | apply IH; intros; apply H;
    simpl; auto]].
    simpl. intros t [K1 K2] b [<-|I]; auto.
Qed.
Lemma soon_exists P : soon P -> exists t, 0 < t /\ P t.
Proof. intros (s & Hs & P1). exists (s/2). split; [lra|apply P1; lra]. Qed.

(** Polynomials by their coefficients; the first that is not zero decides the sign. *)
Fixpoint polynomial (l : list R) (t : R) : R :=
  match l with [] => 0 | c :: r => c + t * polynomial r t end.
Fixpoint leads_positive (l : list R) : Prop :=
  match l with [] => False | c :: r => 0 < c \/ (c = 0 /\ leads_positive r) end.

Lemma polynomial_bound l : exists M, 0 < M /\ forall t, 0 < t < 1 -> - M <= polynomial l t <= M.
Proof.
  induction l as [|c r (M & HM & IH)]; simpl.
  - exists 1. split; [lra|]. intros; lra.
  - exists (Rabs c + M). pose proof (Rabs_pos c). split; [lra|]. intros t Ht. specialize (IH t Ht).
    pose proof (Rle_abs c). pose proof (Rle_abs (- c)). rewrite Rabs_Ropp in *. nra.
Qed.
Lemma soon_positive l : leads_positive l -> soon (fun t => 0 < polynomial l t).
Proof.
  induction l as [|c r IH]; simpl; [tauto|]. intros [H|[-> H]].
  - destruct (polynomial_bound r) as (M & HM & B). exists (Rmin 1 (c / M)).
    assert (0 < c / M) by (apply Rdiv_lt_0_compat; lra).
    split; [apply Rmin_glb_lt; lra|]. intros t [T1 T2].
    assert (t < 1) by (eapply Rlt_le_trans; [exact T2|apply Rmin_l]).
    assert (t < c / M) by (eapply Rlt_le_trans; [exact T2|apply Rmin_r]).
    assert (t * M < c).
    { apply Rmult_lt_compat_r with (r := M) in H2; auto. unfold Rdiv in H2.
      rewrite Rmult_assoc, Rinv_l in H2; lra. }
    assert (- M <= polynomial r t <= M) by (apply B; lra). nra.
  - destruct (IH H) as (t0 & T0 & K). exists t0. split; auto. intros t Ht. specialize (K t Ht). nra.
Qed.

(** The curve x + t d + (t^2, t^3) *)
Definition curve (x d : point) (t : R) : point :=
  (fst x + t * fst d + t * t, snd x + t * snd d + t * t * t).
Definition turn (a b d : point) : R := (fst b - fst a) * snd d - (snd b - snd a) * fst d.
Lemma curve_orient a b x d t : orient a b (curve x d t) =
  polynomial [orient a b x; turn a b d; - (snd b - snd a); fst b - fst a] t.
Proof. unfold orient, curve, turn; simpl; ring. Qed.

Lemma curve_pos a b x d : 0 < orient a b x -> soon (fun t => 0 < orient a b (curve x d t)).
Proof.
  intros H. eapply soon_imp; [|apply soon_positive with (l := [orient a b x; turn a b d;
    - (snd b - snd a); fst b - fst a]);
    simpl; auto]. intros t. rewrite curve_orient. auto.
Qed.
Lemma curve_neg a b x d : orient a b x < 0 -> soon (fun t => orient a b (curve x d t) < 0).
Proof.
  intros H. eapply soon_imp; [|apply (curve_pos b a x d); rewrite orient_swap; lra].
  simpl; intros t. rewrite orient_swap. lra.
Qed.
Lemma curve_off a b x d : a <> b -> soon (fun t => orient a b (curve x d t) <> 0).
Proof.
  intros N. set (l := [orient a b x; turn a b d; - (snd b - snd a); fst b - fst a]).
  assert (H : leads_positive l \/ leads_positive (map Ropp l)).
  { unfold l; simpl. destruct a as [ax ay], b as [bx b_y]; simpl in *.
    assert (M : bx - ax <> 0 \/ b_y - ay <> 0).
    { destruct (Req_dec bx ax), (Req_dec b_y ay); try (left; lra); try (right; lra). subst;
      congruence. }
    set (o := orient (ax, ay) (bx, b_y) x). set (e := turn (ax, ay) (bx, b_y) d).
    destruct (Rtotal_order o 0) as [|[|]], (Rtotal_order e 0) as [|[|]],
      (Rtotal_order (b_y - ay) 0) as [|[|]], (Rtotal_order (bx - ax) 0) as [|[|]]; lra. }
  destruct H as [H|H]; apply soon_positive in H; eapply soon_imp; try exact H; intros t; cbv beta;
    rewrite curve_orient; fold l.
  - lra.
  - intros K E. unfold l in E. simpl in *. lra.
Qed.

(** From a point of a closed triangle the curve to its middle goes inside. *)
Definition middle (a b c : point) : point := ((fst a + fst b + fst c) / 3, (snd a + snd b + snd c)
  / 3).
Definition minus (p q : point) : point := (fst p - fst q, snd p - snd q).
Lemma curve_inside a b c x : 0 < orient a b c -> closed_triangle a b c x ->
  soon (fun t => open_triangle a b c (curve x (minus (middle a b c) x) t)).
Proof.
  intros D (H1 & H2 & H3).
  assert (K : forall u v, 0 <= orient u v x -> orient u v (middle a b c) = orient a b c / 3 ->
     soon (fun t => 0 < orient u v (curve x (minus (middle a b c) x) t))).
  { intros u v H E. eapply soon_imp; [|apply soon_positive with (l := [orient u v x;
      turn u v (minus (middle a b c) x); - (snd v - snd u); fst v - fst u])].
    - intros t. rewrite curve_orient. auto.
    - simpl. assert (turn u v (minus (middle a b c) x) = orient u v (middle a b c) - orient u v x)
        by (unfold turn, minus, orient; simpl; ring).
      destruct H as [H|H]; [left; exact H|right; split; [auto|left; lra]]. }
  apply soon_and; [|apply soon_and]; apply K; auto; unfold orient, middle; simpl; field.
Qed.

Lemma curve_near e x d : 0 < e -> soon (fun t => near e x (curve x d t)).
Proof.
  intros H.
  assert (K : forall u v w, soon (fun t => Rabs (t * u + t * t * v + t * t * t * w) < e)).
  { intros u v w. eapply soon_imp; [|apply soon_and;
      [apply (soon_positive [e; u; v; w])|apply (soon_positive [e; - u; - v; - w])]; simpl; auto].
    simpl. intros t [K1 K2]. apply Rabs_def1; nra. }
  eapply soon_imp; [|apply soon_and; [apply (K (fst d) 1 0)|apply (K (snd d) 0 1)]].
  unfold near, curve; simpl. intros t [K1 K2]. split.
  - replace (fst x + t * fst d + t * t - fst x) with (t * fst d + t * t * 1 + t * t * t * 0) by
    ring. auto.
  - replace (snd x + t * snd d + t * t * t - snd x) with (t * snd d + t * t * 0 + t * t * t * 1) by
    ring. auto.
Qed.

Lemma near_right a b x : orient a b x < 0 ->
  exists e, 0 < e /\ forall y, near e x y -> orient a b y < 0.
Proof.
  intros H. set (A := Rabs (fst b - fst a)). set (B := Rabs (snd b - snd a)).
  assert (0 <= A) by apply Rabs_pos. assert (0 <= B) by apply Rabs_pos.
  exists (- orient a b x / (A + B + 1)). split; [apply Rdiv_lt_0_compat; lra|].
  intros y [N1 N2].
  assert (M : (A + B + 1) * (- orient a b x / (A + B + 1)) = - orient a b x) by (field; lra).
  set (e := - orient a b x / (A + B + 1)) in *.
  assert (E : orient a b y = orient a b x + ((fst b - fst a) * (snd y - snd x) - (snd b - snd a) *
    (fst y - fst x)))
    by (unfold orient; ring).
  assert (T : (fst b - fst a) * (snd y - snd x) - (snd b - snd a) * (fst y - fst x) <= A * e + B *
    e).
  { apply Rle_trans with (Rabs ((fst b - fst a) * (snd y - snd x)) + Rabs ((snd b - snd a) * (fst y
    - fst x))).
    - pose proof (Rle_abs ((fst b - fst a) * (snd y - snd x))).
      pose proof (Rle_abs (- ((snd b - snd a) * (fst y - fst x)))). rewrite Rabs_Ropp in H3. lra.
    - rewrite !Rabs_mult. fold A B. apply Rplus_le_compat; apply Rmult_le_compat_l; lra. }
  pose proof (Rle_lt_trans 0 _ _ (Rabs_pos _) N1). nra.
Qed.
Lemma near_outside a b c x : 0 < orient a b c -> ~ closed_triangle a b c x ->
  exists e, 0 < e /\ forall y, near e x y -> ~ closed_triangle a b c y.
Proof.
  intros D N.
  assert (H : orient a b x < 0 \/ orient b c x < 0 \/ orient c a x < 0).
  { unfold closed_triangle in N. destruct (Rlt_dec (orient a b x) 0), (Rlt_dec (orient b c x) 0),
    (Rlt_dec (orient c a x) 0);
    auto. exfalso; apply N; lra. }
  destruct H as [H|[H|H]]; apply near_right in H; destruct H as (e & He & K); exists e; split; auto;
  intros y Y; specialize (K y Y); unfold closed_triangle; lra.
Qed.

