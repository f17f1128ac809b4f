/*---------------------------------------------------------------------------*\
    monolithicFoam: finite-element fluid-structure interaction for OpenFOAM
    Copyright (C) 2026 the monolithicFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "refuseBlanks.H"
#include "error.H"
#include <climits>
#include <unistd.h>

// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

void Foam::refuseBlanks(const int argc, const char* const* argv)
{
    char here[PATH_MAX];
    std::string path(::getcwd(here, PATH_MAX) ? here : "");
    for (int i = 1; i + 1 < argc; ++i) if (std::string(argv[i]) == "-case") path = argv[i + 1];
    if (path.find_first_of(" \t\n") == std::string::npos) return;
    FatalErrorInFunction
        << "The path of the case, " << path << ", has a blank, with which OpenFOAM does not work: rename"
        << " the directory, or reach it by a symbolic link without blanks and -case" << exit(FatalError, 1);
}


// ************************************************************************* //
