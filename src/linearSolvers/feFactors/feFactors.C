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
    solver_(feLinearSolver::New(dict)),
    owned_(map.ownedUnknowns().size())
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
    const labelList& unknowns = map_.ownedUnknowns();
    forAll(unknowns, i) owned_[i] = b[unknowns[i]];
    const feLinearSolver::outcome o = solver_->solve(owned_);
    x = 0;
    forAll(unknowns, i) x[unknowns[i]] = owned_[i];
    map_.fromOwner(x);
    return o;
}


// ************************************************************************* //
