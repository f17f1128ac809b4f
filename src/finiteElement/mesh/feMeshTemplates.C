/*---------------------------------------------------------------------------*\
    monolithicFoam: finite-element fluid-structure interaction for OpenFOAM
    Copyright (C) 2026 the monolithicFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

template<class Type>
Foam::tmp<Foam::Field<Type>> Foam::feMesh::interpolate
(
    const Field<Type>& pointValues
) const
{
    tmp<Field<Type>> tnodeValues(new Field<Type>(nNodes(), Zero));
    Field<Type>& v = tnodeValues.ref();

    for (label n = 0; n < nVertices_; ++n) v[n] = pointValues[vertexPoint_[n]];

    for (label n = nVertices_; n < nNodes(); ++n)
    {
        for (const label m : parents_[n]) v[n] += v[m];
        v[n] /= scalar(parents_[n].size());
    }
    return tnodeValues;
}


template<class Type>
void Foam::feMesh::toPoints
(
    const Field<Type>& nodeValues,
    Field<Type>& pointValues
) const
{
    forAll(pointNode_, p)
    {
        if (pointNode_[p] >= 0) pointValues[p] = nodeValues[pointNode_[p]];
    }
}
