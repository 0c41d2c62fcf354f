(** Figures that are the same but for order, and where rings start: lists alone, no points. *)
From Coq Require Import Permutation Lia.
From Proved Require Import Definitions Form Moving.

(** ** Turned lists *)
Lemma path_split {A} (l : list A) : forall f p y r,
  path f p (l ++ y :: r) = path y p l ++ path f y r.
Proof. induction l as [|a l IH]; intros f p y r; simpl; [reflexivity|]. rewrite IH. reflexivity.
Qed.
Lemma turned_edges {A} (l k : list A) : turned l k -> turned (ring_edges l) (ring_edges k).
Proof.
  intros (a & b & -> & ->). destruct a as [|x a].
  - exists [], (ring_edges b). rewrite !app_nil_r. auto.
  - destruct b as [|y b].
    + exists [], (ring_edges (x :: a)). rewrite !app_nil_r. auto.
    + exists (path y x a), (path x y b). simpl. rewrite !path_split. auto.
Qed.
Lemma turned_permuted {A} (l k : list A) : turned l k -> Permutation l k.
Proof. intros (a & b & -> & ->). apply Permutation_app_comm. Qed.
Lemma turned_more {A} (l k m : list A) : turned l k -> turned k m -> turned l m.
Proof.
  intros (a & b & -> & ->) (c & d & Q & ->).
  destruct (app_eq_app _ _ _ _ Q) as (z & [[-> ->]|[-> ->]]).
  - exists (a ++ c), z. rewrite <- !app_assoc. auto.
  - exists z, (d ++ b). rewrite <- !app_assoc. auto.
Qed.
Lemma turned_map {A B} (f : A -> B) l k : turned l k -> turned (map f l) (map f k).
Proof. intros (a & b & -> & ->). exists (map f a), (map f b). rewrite !map_app. auto. Qed.

(** ** Lists related in pairs, but for order *)
Definition paired {A} (T : A -> A -> Prop) (l k : list A) : Prop :=
  exists m, Permutation l m /\ Forall2 T m k.
Lemma pairs_permuted {A} (T : A -> A -> Prop) l k m : Forall2 T l k -> Permutation k m ->
  exists n, Permutation l n /\ Forall2 T n m.
Proof.
  intros F P. assert (G : Forall2 (fun a b => T b a) k l) by (clear P; induction F; auto).
  destruct (Permutation_Forall2 P G) as (n & Pn & Gn). exists n. split; auto.
  clear - Gn. induction Gn; auto.
Qed.
Lemma paired_more {A} (T : A -> A -> Prop) l k m : (forall x y z, T x y -> T y z -> T x z) ->
  paired T l k -> paired T k m -> paired T l m.
Proof.
  intros H (l1 & P1 & F1) (k1 & P2 & F2). destruct (pairs_permuted T l1 k k1 F1 P2) as
    (l2 & P3 & F3). exists l2. split; [eapply Permutation_trans; eauto|].
  clear - H F2 F3. revert m F2. induction F3; intros m F2; inversion F2; subst; constructor; eauto.
Qed.
Lemma paired_map {A B} (f : A -> B) (T : A -> A -> Prop) (U : B -> B -> Prop) l k :
  (forall x y, T x y -> U (f x) (f y)) -> paired T l k -> paired U (map f l) (map f k).
Proof.
  intros H (m & P & F). exists (map f m). split; [apply Permutation_map, P|].
  clear - H F. induction F; simpl; constructor; auto.
Qed.
(** Where each entry has a partner, and no two entries the same one, lists are paired. *)
Lemma pairs_match {A} (T : A -> A -> Prop) : forall k l,
  (forall y, In y k -> exists x, In x l /\ T x y) ->
  (forall x, In x l -> exists y, In y k /\ T x y) ->
  ForallOrdPairs (fun x x' => forall y, T x y -> T x' y -> False) l ->
  ForallOrdPairs (fun y y' => forall x, T x y -> T x y' -> False) k -> paired T l k.
Proof.
  induction k as [|y k IH]; intros l H G Pl Pk.
  - exists []. split; [|constructor]. destruct l as [|x l]; auto.
    destruct (G x (or_introl eq_refl)) as (y & [] & _).
  - destruct (H y (or_introl eq_refl)) as (x & I & K). apply in_split in I.
    destruct I as (a & b & ->). inversion Pk as [|? ? Fk Pk' Q]; subst.
    rewrite Forall_forall in Fk.
    assert (Other : ForallOrdPairs (fun x x' => forall y, T x y -> T x' y -> False) (a ++ b) /\
      forall x', In x' (a ++ b) -> ~ T x' y).
    { clear - Pl K. induction a as [|c a IHa]; simpl in *; inversion Pl as [|? ? F P Q]; subst.
      - rewrite Forall_forall in F. split; auto. intros x' I T'. exact (F x' I y K T').
      - destruct (IHa P) as (A1 & A2). rewrite Forall_forall in F. split.
        + constructor; auto. rewrite Forall_forall. intros z I. apply F. apply in_app_or in I.
          apply in_or_app. simpl. tauto.
        + intros x' [<-|I]; auto. intros T'. refine (F x _ y T' K). apply in_or_app. simpl. auto. }
    destruct Other as (Pab & No). destruct (IH (a ++ b)) as (m & P & F); auto.
    + intros z I. destruct (H z (or_intror I)) as (w & J & W). exists w. split; auto.
      apply in_app_or in J. apply in_or_app. destruct J as [J|[<-|J]]; auto.
      destruct (Fk z I x K W).
    + intros z I. destruct (G z) as (w & [<-|J] & W).
      * apply in_app_or in I. apply in_or_app. simpl. tauto.
      * destruct (No z I W).
      * exists w. auto.
    + exists (x :: m). split; [|constructor; auto].
      apply Permutation_sym, Permutation_cons_app, Permutation_sym, P.
Qed.

(** ** Figures *)
Lemma same_polygon_paired {A} (p q : polygon A) : same_polygon p q <->
  turned (fst p) (fst q) /\ paired turned (snd p) (snd q).
Proof. reflexivity. Qed.
Lemma same_polygon_more {A} (p q r : polygon A) : same_polygon p q -> same_polygon q r ->
  same_polygon p r.
Proof.
  rewrite !same_polygon_paired. intros (T1 & H1) (T2 & H2).
  split; [eapply turned_more; eauto|eapply paired_more; eauto; apply turned_more].
Qed.
Lemma same_figure_more {A} (f g h : list (polygon A) * list A) : same_figure f g ->
  same_figure g h -> same_figure f h.
Proof.
  intros (P1 & T1) (P2 & T2). split; [|eapply Permutation_trans; eauto].
  exact (paired_more _ _ _ _ same_polygon_more P1 P2).
Qed.
Definition figure_map {A B} (f : A -> B) (g : list (polygon A) * list A) :=
  (each_vertex f (fst g), map f (snd g)).
Lemma same_figure_map {A B} (f : A -> B) g h : same_figure g h ->
  same_figure (figure_map f g) (figure_map f h).
Proof.
  intros (P & T). split; [|apply Permutation_map, T].
  apply (paired_map _ same_polygon same_polygon); auto. intros p q (U & V). split.
  - apply turned_map, U.
  - apply (paired_map _ turned turned); auto. apply turned_map.
Qed.
