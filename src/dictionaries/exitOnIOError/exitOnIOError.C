/*---------------------------------------------------------------------------*\
    monolithicFoam: finite-element fluid-structure interaction for OpenFOAM
    Copyright (C) 2026 the monolithicFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "exitOnIOError.H"
#include "error.H"
#include "Pstream.H"
#include <exception>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

static void endRun()
{
    try
    {
        if (const auto thrown = std::current_exception()) std::rethrow_exception(thrown);
    }
    catch (const IOerror& e)
    {
        Perr<< nl << e << nl << "\nFOAM exiting\n" << endl;
        Pstream::exit(1);
    }
    catch (...)
    {}
    std::abort();
}

} // End namespace Foam


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

void Foam::exitOnIOError()
{
    // Nobody catches them: the stack is not unwound, whose destructors would
    // wait for other ranks
    FatalIOError.throwExceptions();
    std::set_terminate(endRun);
}


// ************************************************************************* //
