/*---------------------------------------------------------------------------*\
    monolithicFoam: finite-element fluid-structure interaction for OpenFOAM
    Copyright (C) 2026 the monolithicFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "dofConstraints.H"

// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::dofConstraints::tie
(
    const label unknown,
    const UList<term>& masters
)
{
    if (row_[unknown] < 0)
    {
        row_[unknown] = terms_.size();
        terms_.append(DynamicList<term>());
    }
    terms_[row_[unknown]] = masters;
}


void Foam::dofConstraints::close()
{
    bool changed = true;
    for (label pass = 0; changed; ++pass)
    {
        changed = false;
        forAll(row_, i)
        {
            if (!isTied(i)) continue;
            DynamicList<term>& row = terms_[row_[i]];
            DynamicList<term> closed;
            for (const term& t : row)
            {
                if (isFree(t.unknown)) closed.append(t);
                else changed = true;

                if (!isTied(t.unknown)) continue;
                if (t.unknown == i || pass > row_.size())
                {
                    FatalErrorInFunction
                        << "The constraint of unknown " << i
                        << " refers to itself through unknown " << t.unknown
                        << exit(FatalError);
                }
                for (const term& m : masters(t.unknown))
                {
                    closed.append({m.unknown, t.weight*m.weight});
                }
            }
            row.transfer(closed);
        }
    }
    forAll(row_, i) if (isTied(i) && masters(i).empty()) row_[i] = FIXED;
}


void Foam::dofConstraints::distribute(scalarField& dx) const
{
    forAll(row_, i)
    {
        if (isFree(i)) continue;
        dx[i] = 0;
        if (isTied(i)) for (const term& t : masters(i)) dx[i] += t.weight*dx[t.unknown];
    }
}


void Foam::dofConstraints::condense(scalarField& r) const
{
    forAll(row_, i)
    {
        if (isFree(i)) continue;
        if (isTied(i)) for (const term& t : masters(i)) r[t.unknown] += t.weight*r[i];
        r[i] = 0;
    }
}


// ************************************************************************* //
