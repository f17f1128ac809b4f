/*---------------------------------------------------------------------------*\
    monolithicFoam: finite-element fluid-structure interaction for OpenFOAM
    Copyright (C) 2026 the monolithicFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "CGALRemesher.H"
#include "addToRunTimeSelectionTable.H"
#include "unknownEntries.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace remeshers
{
    defineTypeNameAndDebug(CGAL, 0);
    addToRunTimeSelectionTable(remesher, CGAL, dictionary);
}
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::remeshers::CGAL::CGAL(const dictionary& coeffs)
:
    nIterations_(coeffs.getOrDefault<label>("iterations", 3))
{
    reportUnknownEntries(coeffs, {"iterations"});
    if (nIterations_ < 1)
    {
        FatalIOErrorInFunction(coeffs)
            << "iterations is " << nIterations_ << ", expected 1 or more" << exit(FatalIOError);
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

Foam::string Foam::remeshers::CGAL::remesh
(
    const simplexMesh& old,
    const sizeField& size,
    simplexMesh& now
) const
{
    now.dim = old.dim;
    return
        old.dim == 2
      ? remeshTriangles(old, size, nIterations_, now)
      : remeshTets(old, size, nIterations_, now);
}


// ************************************************************************* //
