/*---------------------------------------------------------------------------*\
    monolithicFoam: finite-element fluid-structure interaction for OpenFOAM
    Copyright (C) 2026 the monolithicFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "fsiInterface.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::fsiInterface::fsiInterface
(
    const word& name,
    const dictionary& dict,
    PtrList<feRegion>& regions
)
:
    feInterface(name, dict, regions, "solid", "fluid"),
    followed_(false)
{
    if (fluid().leads() || !solid().leads()) failRegions("a fluid and a solid");
}


// ************************************************************************* //
