/*---------------------------------------------------------------------------*\
    monolithicFoam: finite-element fluid-structure interaction for OpenFOAM
    Copyright (C) 2026 the monolithicFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "simplexQuality.H"
#include "referenceElements.H"
#include "jacobianBound.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

template<class E>
static scalar least(const simplexMesh& mesh)
{
    jacobianBound<E> bound;
    Vec<double, E::dim> x[E::nNodes];
    scalar s = 1;
    for (const labelList& cell : mesh.cells)
    {
        forAll(cell, i) for (int a = 0; a < E::dim; ++a) x[i][a] = mesh.points[cell[i]][a];
        s = min(s, bound(x));
    }
    return s;
}

} // End namespace Foam


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

Foam::scalar Foam::leastScaledJacobian(const simplexMesh& mesh)
{
    return mesh.dim == 2 ? least<Tri1>(mesh) : least<Tet1>(mesh);
}


// ************************************************************************* //
