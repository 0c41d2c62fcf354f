(** The numbers of the checker: a rational number, or a form in t and u, by its coefficients, whose
    value between two scales is that at t + u = 1: [a; b] goes from a to b in a straight line. Every
    test that says yes holds for all t, u > 0; it may say no though it holds. *)
From Coq Require Import Bool ZArith QArith List.
From Proved Require Export Order.
Open Scope Q_scope.

Inductive number := Fixed (q : Q) | Moving (l : list Q).

(** Forms as polynomials in u / t *)
Fixpoint plus (l k : list Q) : list Q :=
  match l, k with
  | nil, _ => k
  | _, nil => l
  | a :: l', b :: k' => a + b :: plus l' k'
  end.
Definition times_number (a : Q) (l : list Q) : list Q := map (Qmult a) l.
Fixpoint times (l k : list Q) : list Q :=
  match l with nil => nil | a :: l' => plus (times_number a k) (0 :: times l' k) end.
Definition less_form (l k : list Q) : list Q := plus l (times_number (-1) k).
Definition are_of_sign (l : list Q) : bool :=
  forallb (Qle_bool 0) l && existsb (less 0) l.

(** The same form, of a larger degree: times t + u *)
Definition raise (l : list Q) : list Q := plus l (0 :: l).
Fixpoint raised (n : nat) (l : list Q) : list Q :=
  match n with O => l | S m => raised m (raise l) end.
Definition leveled (f : list Q -> list Q -> list Q) (l k : list Q) : list Q :=
  f (raised (length k - length l) l) (raised (length l - length k) k).

Definition coefficients_of (a : number) : list Q :=
  match a with Fixed q => q :: nil | Moving l => l end.
Definition moved (f : list Q -> list Q -> list Q) (a b : number) : number :=
  Moving (f (coefficients_of a) (coefficients_of b)).

Definition nplus (a b : number) : number :=
  match a, b with Fixed p, Fixed q => Fixed (p + q) | _, _ => moved (leveled plus) a b end.
Definition nminus (a b : number) : number :=
  match a, b with Fixed p, Fixed q => Fixed (p - q) | _, _ => moved (leveled less_form) a b end.
Definition ntimes (a b : number) : number :=
  match a, b with
  | Fixed p, Fixed q => Fixed (p * q)
  | Fixed p, Moving k => Moving (times_number p k)
  | Moving l, Fixed q => Moving (times_number q l)
  | Moving l, Moving k => Moving (times l k)
  end.
Definition reduced (a : number) : number :=
  match a with Fixed q => Fixed (Qred q) | Moving l => Moving (map Qred l) end.
Definition difference (b a : number) : list Q := coefficients_of (nminus b a).
Definition lt (a b : number) : bool :=
  match a, b with Fixed p, Fixed q => less p q | _, _ => are_of_sign (difference b a) end.
Definition le (a b : number) : bool :=
  match a, b with
  | Fixed p, Fixed q => Qle_bool p q
  | _, _ => forallb (Qle_bool 0) (difference b a)
  end.
Definition equal (a b : number) : bool :=
  match a, b with
  | Fixed p, Fixed q => Qeq_bool p q
  | _, _ => forallb (Qeq_bool 0) (difference b a)
  end.
Definition differ (a b : number) : bool := lt a b || lt b a.

(** A number that is at least both *)
Definition larger (x y : Q) : Q := if Qle_bool x y then y else x.
Fixpoint largest (l k : list Q) : list Q :=
  match l, k with a :: l', b :: k' => larger a b :: largest l' k' | _, _ => nil end.
Definition greater_of (a b : number) : number :=
  match a, b with Fixed p, Fixed q => Fixed (larger p q) | _, _ => moved (leveled largest) a b end.

(** What a is over b, where it does not move; else anything *)
Fixpoint ratio (l k : list Q) : Q :=
  match l, k with
  | a :: l', b :: k' => if Qeq_bool b 0 then ratio l' k' else Qred (a / b)
  | _, _ => 0
  end.
Definition over (a b : number) : number :=
  match a, b with
  | Fixed p, Fixed q => Fixed (Qred (p / q))
  | _, _ => Fixed (hd 0 (leveled (fun l k => ratio l k :: nil) (coefficients_of a)
    (coefficients_of b)))
  end.

Definition zero : number := Fixed 0.
Definition one : number := Fixed 1.
Definition half : number := Fixed (1 # 2).

Declare Scope number_scope.
Delimit Scope number_scope with n.
Infix "+" := nplus : number_scope.
Infix "-" := nminus : number_scope.
Infix "*" := ntimes : number_scope.
