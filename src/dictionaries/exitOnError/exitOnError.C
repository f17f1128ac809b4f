/*---------------------------------------------------------------------------*\
    monolithicFoam: finite-element fluid-structure interaction for OpenFOAM
    Copyright (C) 2026 the monolithicFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "exitOnError.H"
#include "error.H"
#include "Pstream.H"
#include <cfenv>
#include <exception>

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

template<class Error>
static void endWith(const Error& e)
{
    Perr<< nl << e << nl << "\nFOAM exiting\n" << endl;
    Pstream::exit(1);
}


static void endRun()
{
    try
    {
        if (const auto thrown = std::current_exception()) std::rethrow_exception(thrown);
    }
    catch (const IOerror& e)
    {
        endWith(e);
    }
    catch (const error& e)
    {
        endWith(e);
    }
    catch (...)
    {}
    std::abort();
}

} // End namespace Foam


// * * * * * * * * * * * * * * * Global Functions  * * * * * * * * * * * * * //

void Foam::exitOnError()
{
    // Nobody catches them: the stack is not unwound, whose destructors would
    // wait for other ranks
    FatalError.throwExceptions();
    FatalIOError.throwExceptions();
    fedisableexcept(FE_OVERFLOW);
    std::set_terminate(endRun);
}


// ************************************************************************* //
