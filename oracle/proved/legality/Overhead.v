(** How often closed rings wind around points of an edge: near one that is on no other, the rest
    winds alike; and around any point as the lowest edge above it tells. *)
From Coq Require Import Lra Lia Psatz Permutation Bool QArith Qreals ZArith Classical.
From Proved Require Import Definitions Form Legality Sums Crossings Fans Curves Unions Local Across
  Overlaps Components Paths Decomposed Gaps Unique Boundaries Rounds.
Open Scope R_scope.

Lemma winding_app E F y : winding (E ++ F) y = (winding E y + winding F y)%Z.
Proof.
  induction E as [|[a b] E IH]; auto. rewrite <- app_comm_cons, !winding_cons, IH. lia.
Qed.
Lemma winding_without l e r y :
  winding (l ++ e :: r) y = (winding (l ++ r) y + crossing (fst e) (snd e) y)%Z.
Proof. destruct e as [a b]. rewrite !winding_app, winding_cons. cbn [fst snd]. lia. Qed.

(** Near a point on none of them, edges wind as often but for what changes at their ends. *)
Lemma winding_but_ends E x : (forall f, In f E -> ~ on_segment (fst f) (snd f) x) ->
  exists r C, 0 < r /\ forall y, near r x y ->
    winding E y = (C + sumz (fun v => change x v y) (map snd E)
      - sumz (fun v => change x v y) (map fst E))%Z.
Proof.
  induction E as [|[a b] E IH]; intros N; [exists 1, 0%Z; split; [lra|reflexivity]|].
  destruct IH as (e & C & He & H); [intros f I; apply N; simpl; auto|].
  destruct (crossing_near a b x) as (f & D & Hf & G); [apply (N (a, b)); simpl; auto|].
  exists (Rmin e f), (C + D)%Z. split; [apply Rmin_glb_lt; auto|].
  intros y Y. apply near_min in Y. destruct Y as [Y1 Y2]. specialize (H y Y1). specialize (G y Y2).
  rewrite winding_cons, G, H. unfold sumz. simpl. lia.
Qed.
Lemma winding_near_edge l e r x : closed (l ++ e :: r) ->
  fst (fst e) <> fst x -> fst (snd e) <> fst x ->
  (forall f, In f (l ++ r) -> ~ on_segment (fst f) (snd f) x) ->
  exists s, 0 < s /\ forall y, near s x y -> winding (l ++ r) y = winding (l ++ r) x.
Proof.
  intros Cl A B N. destruct (winding_but_ends (l ++ r) x N) as (s & C & Hs & H).
  exists s. split; auto.
  assert (K : forall y, near s x y -> winding (l ++ r) y = C).
  { intros y Y. rewrite (H y Y). pose proof (sumz_perm (fun v => change x v y) _ _ Cl) as P.
    rewrite !map_app, !sumz_app in *. simpl in P. rewrite !change_off in P by auto.
    fold (sumz (fun v => change x v y)) in P. lia. }
  intros y Y. rewrite (K y Y), (K x (near_self s x Hs)). reflexivity.
Qed.

Lemma crossing_on a b y : orient a b y = 0 -> crossing a b y = 0%Z.
Proof. intros O. unfold crossing. rewrite O. split_decisions; auto; exfalso; lra. Qed.
(** The crossing number of an edge on a vertical line: up to a height, if at all *)
Definition comes (a b : point) (x : R) : Z :=
  if Rle_dec (fst a) x then if Rlt_dec x (fst b) then (-1)%Z else 0%Z
  else if Rle_dec (fst b) x then 1%Z else 0%Z.
Definition height_at (a b : point) (x : R) : R :=
  snd a + (x - fst a) / (fst b - fst a) * (snd b - snd a).
Lemma orient_height a b x s : fst a <> fst b ->
  orient a b (x, s) = (fst b - fst a) * (s - height_at a b x).
Proof. intros N. unfold orient, height_at; cbn [fst snd]. field. lra. Qed.
Lemma crossing_below a b x s : crossing a b (x, s) =
  if Rlt_dec s (height_at a b x) then comes a b x else 0%Z.
Proof.
  destruct (Req_dec (fst a) (fst b)) as [E|N].
  { rewrite crossing_vertical by exact E. unfold comes. rewrite E.
    split_decisions; auto; exfalso; lra. }
  unfold crossing, comes. rewrite (orient_height a b x s N). cbn [fst snd].
  split_decisions; auto; exfalso; nra.
Qed.
Lemma comes_on a b x : comes a b x <> 0%Z -> on_segment a b (x, height_at a b x).
Proof.
  intros H. exists ((x - fst a) / (fst b - fst a)).
  assert (G : fst a <= x < fst b \/ fst b <= x < fst a).
  { revert H. unfold comes.
    split_decisions; intros H; try lra; destruct (H eq_refl). }
  assert (K : (x - fst a) / (fst b - fst a) * (fst b - fst a) = x - fst a) by (field; lra).
  unfold height_at. set (t := (x - fst a) / (fst b - fst a)) in *. clearbody t.
  split; [destruct G; nra|]. f_equal. lra.
Qed.

(** The lowest edge straight above a point, if there is one *)
Lemma lowest_above (F : edges_t) (y : point) :
  (forall f, In f F -> crossing (fst f) (snd f) y = 0%Z) \/
  exists e, In e F /\ crossing (fst e) (snd e) y <> 0%Z /\
    forall f, In f F -> crossing (fst f) (snd f) y <> 0%Z ->
      height_at (fst e) (snd e) (fst y) <= height_at (fst f) (snd f) (fst y).
Proof.
  induction F as [|f F IH]; [left; intros f []|].
  destruct (Z.eq_dec (crossing (fst f) (snd f) y) 0) as [Z|N];
    destruct IH as [IH|(e & I & K & M)].
  - left. intros g [<-|J]; auto.
  - right. exists e. split; [simpl; auto|split; auto]. intros g [<-|J] G; auto. contradiction.
  - right. exists f. split; [simpl; auto|split; auto]. intros g [<-|J] G; [lra|].
    destruct (G (IH g J)).
  - right. destruct (Rle_dec (height_at (fst e) (snd e) (fst y))
      (height_at (fst f) (snd f) (fst y))) as [L|L].
    + exists e. split; [simpl; auto|split; auto]. intros g [<-|J] G; auto.
    + exists f. split; [simpl; auto|split; auto]. intros g [<-|J] G; [lra|].
      specialize (M g J G). lra.
Qed.
Lemma winding_none F y : (forall f, In f F -> crossing (fst f) (snd f) y = 0%Z) ->
  winding F y = 0%Z.
Proof.
  induction F as [|[a b] F IH]; intros H; auto. rewrite winding_cons, IH.
  - specialize (H (a, b) (or_introl eq_refl)). cbn [fst snd] in H. rewrite H. reflexivity.
  - intros f I. apply H. simpl. auto.
Qed.
Lemma winding_same F y z : (forall f, In f F -> crossing (fst f) (snd f) y =
  crossing (fst f) (snd f) z) -> winding F y = winding F z.
Proof.
  induction F as [|[a b] F IH]; intros H; auto. rewrite !winding_cons, IH.
  - specialize (H (a, b) (or_introl eq_refl)). cbn [fst snd] in H. rewrite H. reflexivity.
  - intros f I. apply H. simpl. auto.
Qed.
(** Up to it, nothing changes; there, the edge itself is left out. *)
Lemma winding_up_to l e r y : let z := (fst y, height_at (fst e) (snd e) (fst y)) in
  crossing (fst e) (snd e) y <> 0%Z ->
  (forall f, In f (l ++ e :: r) -> crossing (fst f) (snd f) y <> 0%Z ->
    height_at (fst e) (snd e) (fst y) <= height_at (fst f) (snd f) (fst y)) ->
  (forall f, In f (l ++ r) -> ~ on_segment (fst f) (snd f) z) ->
  winding (l ++ e :: r) y = (winding (l ++ r) z + comes (fst e) (snd e) (fst y))%Z.
Proof.
  intros z N M Off. rewrite winding_without. f_equal.
  - apply winding_same. intros f I. destruct y as [x s]. unfold z. cbn [fst] in *.
    assert (Mf : crossing (fst f) (snd f) (x, s) <> 0%Z -> height_at (fst e) (snd e) x <=
      height_at (fst f) (snd f) x).
    { apply M. apply in_app_or in I. apply in_or_app. simpl. tauto. }
    rewrite crossing_below in N, Mf |- *. rewrite crossing_below.
    destruct (Z.eq_dec (comes (fst f) (snd f) x) 0) as [Z|Z].
    { rewrite Z. split_decisions; auto. }
    destruct (Rlt_dec s (height_at (fst e) (snd e) x)); [|contradiction].
    destruct (Rlt_dec s (height_at (fst f) (snd f) x)).
    + specialize (Mf Z). assert (D : height_at (fst f) (snd f) x <> height_at (fst e) (snd e) x).
      { intros E. apply (Off f I). unfold z. cbn [fst]. rewrite <- E. apply comes_on, Z. }
      destruct (Rlt_dec (height_at (fst e) (snd e) x) (height_at (fst f) (snd f) x)); auto. lra.
    + destruct (Rlt_dec (height_at (fst e) (snd e) x) (height_at (fst f) (snd f) x)); auto. lra.
  - destruct y as [x s]. rewrite crossing_below in *. cbn [fst].
    destruct (Rlt_dec s _); auto. contradiction.
Qed.
