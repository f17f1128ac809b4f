/*---------------------------------------------------------------------------*\
    monolithicFoam: finite-element fluid-structure interaction for OpenFOAM
    Copyright (C) 2026 the monolithicFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "remesher.H"
#include "dlLibraryTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
    defineTypeNameAndDebug(remesher, 0);
    defineRunTimeSelectionTable(remesher, dictionary);
}


// * * * * * * * * * * * * * * * * Selectors * * * * * * * * * * * * * * * * //

Foam::autoPtr<Foam::remesher> Foam::remesher::New(const dictionary& dict, const Time& runTime)
{
    const word type(dict.get<word>("remesher"));
    const fileName library("libfeRemesher" + type + ".so");
    const auto known = [&]()
    {
        return dictionaryConstructorTablePtr_ && dictionaryConstructorTablePtr_->found(type);
    };
    if (!known()) const_cast<Time&>(runTime).libs().open(library, false);
    if (!known())
    {
        FatalIOErrorInFunction(dict)
            << "Unknown remesher " << type << ", and no library " << library << " has it. Valid: "
            << (dictionaryConstructorTablePtr_ ? dictionaryConstructorTablePtr_->sortedToc() : wordList())
            << nl << "The remesher CGAL is built by Allwmake where etc/bootstrap has found the"
            << " headers of CGAL" << exit(FatalIOError);
    }
    return dictionaryConstructorTablePtr_->cfind(type)()(dict.subOrEmptyDict(type + "Coeffs"));
}


// ************************************************************************* //
