(** A ring as a way: from the end of an edge on along the next ones, around to its start. *)
From Coq Require Import Lra Lia Psatz Permutation Classical.
From Proved Require Import Definitions Form Sums Crossings Fans Curves Unions Local Across Overlaps
  Components.
From Proved Require Import OneForm Paths Decomposed Gaps Unique Boundaries Beside.
Open Scope R_scope.

Inductive chain : point -> edges_t -> point -> Prop :=
| chain_none x : chain x [] x
| chain_more x y z E : chain y E z -> chain x ((x, y) :: E) z.
Lemma chain_join x E y F z : chain x E y -> chain y F z -> chain x (E ++ F) z.
Proof. induction 1; simpl; auto. intros K. apply chain_more, IHchain, K. Qed.
Lemma chain_split E : forall x e F z, chain x (E ++ e :: F) z ->
  chain x E (fst e) /\ chain (snd e) F z.
Proof.
  induction E as [|d E IH]; simpl; intros x e F z K; inversion K; subst.
  - split; [apply chain_none|auto].
  - destruct (IH _ _ _ _ H3). split; auto. apply chain_more. auto.
Qed.
Lemma path_chain rest : forall first previous : point,
  chain previous (path first previous rest) first.
Proof.
  induction rest as [|n rest IH]; intros f p; simpl; [apply chain_more, chain_none|].
  apply chain_more, IH.
Qed.
Lemma ring_chain (R : list point) : exists x, chain x (ring_edges R) x.
Proof. destruct R as [|a R]; [exists (0, 0); apply chain_none|exists a; apply path_chain]. Qed.

(** An entry of a list with the one after it, or the last with the first *)
Lemma path_pair {A} rest : forall (first previous : A) e f, In (e, f) (path first previous rest) ->
  (exists l r, previous :: rest = l ++ e :: f :: r) \/
  (f = first /\ exists l, previous :: rest = l ++ [e]).
Proof.
  induction rest as [|n rest IH]; intros first p e f; simpl; intros [Q|I].
  - injection Q; intros; subst. right. split; auto. exists []. auto.
  - destruct I.
  - injection Q; intros; subst. left. exists [], rest. auto.
  - destruct (IH _ _ _ _ I) as [(l & r & ->)|(-> & l & ->)].
    + left. exists (p :: l), r. auto.
    + right. split; auto. exists (p :: l). auto.
Qed.
Lemma ring_pair {A} (L : list A) e f : In (e, f) (ring_edges L) ->
  (L = [e] /\ f = e) \/ (exists l r, L = l ++ e :: f :: r) \/ exists l, L = f :: l ++ [e].
Proof.
  destruct L as [|a L]; [intros []|]. intros I. simpl in I.
  destruct (path_pair _ _ _ _ _ I) as [K|(-> & [|b l] & Q)]; [right; left; exact K| |].
  - injection Q; intros; subst. left. auto.
  - injection Q; intros; subst. right. right. exists l. auto.
Qed.
(** An entry of a list whose entries are related in pairs, with those before and after it *)
Lemma pairs_at {A} (R : A -> A -> Prop) l e r : ForallOrdPairs R (l ++ e :: r) ->
  (forall f, In f l -> R f e) /\ (forall f, In f r -> R e f).
Proof.
  induction l as [|g l IH]; simpl; intros H; inversion H as [|x k F G]; subst.
  - split; [intros f []|]. rewrite Forall_forall in F. exact F.
  - destruct (IH G) as [I J]. split; auto. intros f [<-|K]; auto. rewrite Forall_forall in F.
    apply F. apply in_or_app. simpl. auto.
Qed.
Lemma pairs_split {A} (R : A -> A -> Prop) e r l : ForallOrdPairs R (l ++ e :: r) ->
  forall g, In g (l ++ r) -> R e g \/ R g e.
Proof. intros P g I. destruct (pairs_at R l e r P). apply in_app_or in I. destruct I; auto. Qed.

Definition apart_from (e f : point * point) : Prop :=
  forall x, beyond_start e x -> beyond_start f x -> False.
Lemma ring_long R e : is_ring R -> In e (ring_edges R) -> fst e <> snd e.
Proof. destruct e as [a b]. apply ring_edge_long. Qed.
Lemma around R e f : is_ring R -> In (e, f) (ring_edges (ring_edges R)) ->
  In e (ring_edges R) /\ In f (ring_edges R) /\ snd e = fst f /\ apart_from e f /\
  orient (fst e) (snd e) (snd f) <> 0 /\ exists E, chain (snd f) E (fst e) /\
    forall g, In g E -> In g (ring_edges R) /\ apart_from e g /\ apart_from f g.
Proof.
  intros (P & T) I. pose proof (T e f I) as N. destruct (ring_chain R) as (x & Ch).
  set (L := ring_edges R) in *. clearbody L.
  assert (Sym : forall a b, apart_from a b \/ apart_from b a -> apart_from a b)
    by (intros a b [H|H] y A B; eauto).
  destruct (ring_pair L e f I) as [[-> ->]|[(l & r & ->)|(l & ->)]].
  - exfalso. apply N. unfold orient. ring.
  - pose proof (pairs_split _ e (f :: r) l P) as Pe.
    assert (P' : ForallOrdPairs (fun e f => forall x, beyond_start e x -> beyond_start f x -> False)
      ((l ++ [e]) ++ f :: r)) by (rewrite <- app_assoc; exact P).
    pose proof (pairs_split _ f r _ P') as Pf.
    destruct (chain_split _ _ _ _ _ Ch) as (C1 & C2). inversion C2; subst.
    split; [apply in_or_app; simpl; auto|]. split; [apply in_or_app; simpl; auto|].
    split; [reflexivity|]. split; [apply Sym, Pe, in_or_app; simpl; auto|]. split; auto.
    exists (r ++ l). split; [apply chain_join with x; auto|]. intros g G.
    apply in_app_or in G. split; [|split].
    + apply in_or_app. simpl. tauto.
    + apply Sym, Pe, in_or_app. simpl. tauto.
    + apply Sym, Pf, in_or_app. rewrite in_app_iff. tauto.
  - assert (P' : ForallOrdPairs (fun e f => forall x, beyond_start e x -> beyond_start f x -> False)
      ((f :: l) ++ [e])) by exact P.
    pose proof (pairs_split _ e [] _ P') as Pe. pose proof (pairs_split _ f (l ++ [e]) [] P) as Pf.
    destruct (chain_split [] _ _ _ _ Ch) as (C1 & C2). inversion C1.
    destruct (chain_split _ _ _ _ _ C2) as (C3 & C4). inversion C4.
    split; [simpl; rewrite in_app_iff; simpl; auto|]. split; [simpl; auto|].
    split; [congruence|]. split; [apply Sym, Pe; simpl; auto|]. split; auto.
    exists l. split; [exact C3|]. intros g G. split; [|split].
    + simpl. rewrite in_app_iff. auto.
    + apply Sym, Pe. rewrite app_nil_r. simpl. auto.
    + apply Sym, Pf. simpl. rewrite in_app_iff. auto.
Qed.

(** The edge by which a ring leaves a point of an edge: the same one, or at its end the next one *)
Definition leaves (R : list point) (e : point * point) (v : point) (h : point * point) : Prop :=
  (h = e /\ v <> snd e) \/ (v = snd e /\ In (e, h) (ring_edges (ring_edges R))).
Lemma chain_avoids C v : forall E x y, chain x E y -> x <> v ->
  (forall a b, In (a, b) E -> (forall p, on_segment a b p -> ~ C p) /\ ~ beyond_start (a, b) v) ->
  joined (outside_it C v) x y.
Proof.
  induction 1 as [x|x y z E K IH]; intros N H; [apply here|].
  destruct (H x y (or_introl eq_refl)) as (A & B).
  assert (Off : ~ on_segment x y v) by (intros O; apply B; split; auto).
  apply joined_join with y; [|apply IH; [intros ->; apply Off, on_segment_end|intros; apply H;
    simpl; auto]].
  apply joined_step. intros p O. split; [intros ->; auto|auto].
Qed.
Lemma way_round C R e v h : is_ring R -> In e (ring_edges R) -> beyond_start e v ->
  leaves R e v h -> (forall a b p, In (a, b) (ring_edges R) -> on_segment a b p -> ~ C p) ->
  In h (ring_edges R) /\ on_segment (fst h) (snd h) v /\ v <> snd h /\
  joined (outside_it C v) (snd h) (fst e).
Proof.
  intros Rg I B L Out. destruct L as [[-> N]|[-> J]].
  - split; auto. split; [apply B|]. split; auto. destruct (ring_next _ _ I) as (f & J).
    destruct (around R e f Rg J) as (_ & If & Ef & A & _ & E & Ch & K).
    apply (chain_avoids C v (f :: E)); auto.
    + rewrite Ef. destruct f as [f1 f2]. apply chain_more, Ch.
    + intros a b [Q|G].
      * subst f. split; [eauto|]. intros X. apply (A v); auto.
      * destruct (K _ G) as (G1 & G2 & _). split; [eauto|]. intros X. apply (G2 v); auto.
  - destruct (around R e h Rg J) as (_ & Ih & Eh & A & _ & E & Ch & K).
    pose proof (ring_long R h Rg Ih) as Lh. split; auto.
    rewrite Eh. split; [apply on_segment_start|]. split; auto.
    apply (chain_avoids C (fst h) E); auto. intros a b G. destruct (K _ G) as (G1 & G2 & _).
    split; [eauto|]. intros X. apply (G2 (snd e)); auto. rewrite Eh. exact X.
Qed.
