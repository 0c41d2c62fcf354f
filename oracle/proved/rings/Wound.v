(** Pieces that close up wind once around what is in the set, and not around the rest. *)
From Coq Require Import Lra Lia Psatz Bool QArith Qreals ZArith Permutation Classical.
From Proved Require Import Definitions Form Sums Crossings Curves Local Across Overlaps Components
  OneForm Paths Decomposed Gaps Unique.
From Proved Require Import Points Member Pieces Slabs Along Cuts Lone Flanks Frontier Slabbed
  Cells Upright.
Open Scope R_scope.

Section Wound.
Variable S : point -> Prop.
Hypothesis regular : is_regular S.
Variable G : list edge.
Hypothesis steady_off : forall x, ~ over_some G x -> steady S x.
Hypothesis long : forall e, In e G -> start e <> finish e.
Hypothesis sided : forall e x, In e G -> inside e x -> exists r, 0 < r /\ forall y, near r x y ->
  (0 < orient (start e) (finish e) y -> S y) /\ (orient (start e) (finish e) y < 0 -> ~ S y).
Hypothesis apart : ForallOrdPairs (fun e f => forall x, inside e x -> inside f x -> False) G.
Variable high : R.
Hypothesis to_high : forall y, S y -> snd y <= high.
Let E := map R2e G.
Hypothesis closes : closed E.

Definition right_there (y : point) : Prop :=
  (S y /\ winding E y = 1%Z) \/ (~ S y /\ winding E y = 0%Z).
Theorem winds_right y : ~ over_some G y -> right_there y.
Proof.
  intros N. destruct (wound_near G closes y N) as (r & R & A).
  destruct (steady_off y N) as (s & Hs & D).
  destruct (aside_near G long y (Rmin r s)) as (z & Z & Nz & Off); [apply Rmin_glb_lt; auto|].
  apply near_min in Z. destruct (A z (proj1 Z)) as [_ Wz]. unfold right_there.
  rewrite <- (D z (proj2 Z)). unfold E. rewrite <- Wz, (surjective_pairing z).
  apply (wound_on_line G long apart closes (fst z)) with (high := high); auto.
  - intros e I. destruct (wall_at G e I) as (p & q & P & Q & <- & <-). auto.
  - rewrite <- surjective_pairing. exact Nz.
Qed.
Theorem region_of_pieces x : region E x <-> S x.
Proof.
  destruct regular as [Closed Reg]. split.
  - intros H. apply Closed. intros e He. destruct (H e He) as (y & Y & O & W).
    exists y. split; auto. destruct (winds_right y) as [[K _]|[_ K]]; auto; [|lia].
    rewrite (over_real G). intros (a & b & I & S1). exact (O a b I S1).
  - intros Sx e He. destruct (Reg x (e / 2) Sx ltac:(lra)) as (p & P & (r & R & K)).
    destruct (aside_near G long p (Rmin r (e / 2))) as (y & Y & N & _); [apply Rmin_glb_lt; lra|].
    apply near_min in Y. destruct Y as [Y1 Y2]. exists y. split; [exact (near_near e x p y P Y2)|].
    split.
    + intros a b I O. apply N, (over_real G). exists a, b. auto.
    + destruct (winds_right y N) as [[_ W]|[W _]]; [lia|]. destruct (W (K y Y1)).
Qed.
End Wound.
