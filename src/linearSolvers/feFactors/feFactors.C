/*---------------------------------------------------------------------------*\
    monolithicFoam: finite-element fluid-structure interaction for OpenFOAM
    Copyright (C) 2026 the monolithicFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "feFactors.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::feFactors::feFactors
(
    const nodeMap& map,
    feMatrix& matrix,
    const dictionary& dict
)
:
    map_(map),
    matrix_(matrix),
    solver_(feLinearSolver::New(dict))
{
    feMatrixPattern pattern;
    pattern.unknowns = map.numbering();
    DynamicList<label> starts;
    for (const label node : map.ownedNodes())
    {
        if (map.nUnknowns(node)) starts.append(map.global(map.start(node)));
    }
    pattern.nodeStart.transfer(starts);
    matrix.triplets(pattern.row, pattern.col);
    solver_->analyse(pattern);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::feLinearSolver::outcome Foam::feFactors::factorise()
{
    matrix_.values(values_);
    return solver_->factorise(values_);
}


Foam::feLinearSolver::outcome Foam::feFactors::solve
(
    const scalarField& b,
    scalarField& x
)
{
    UList<scalarField> column(&x, 1);
    return solve(UList<scalarField>(const_cast<scalarField*>(&b), 1), column);
}


Foam::feLinearSolver::outcome Foam::feFactors::solve
(
    const UList<scalarField>& b,
    UList<scalarField>& x
)
{
    const labelList& unknowns = map_.ownedUnknowns();
    const label n = unknowns.size();

    owned_.setSize(b.size()*n);
    forAll(b, r) forAll(unknowns, i) owned_[r*n + i] = b[r][unknowns[i]];
    const feLinearSolver::outcome o = solver_->solve(owned_, b.size());
    forAll(x, r)
    {
        x[r] = 0;
        forAll(unknowns, i) x[r][unknowns[i]] = owned_[r*n + i];
        map_.fromOwner(x[r]);
    }
    return o;
}


// ************************************************************************* //
