/*---------------------------------------------------------------------------*\
    monolithicFoam: finite-element fluid-structure interaction for OpenFOAM
    Copyright (C) 2026 the monolithicFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "profileCode.H"
#include "dynamicCode.H"
#include "OFstream.H"
#include "OSspecific.H"
#include "Pstream.H"
#include "SHA1Digest.H"
#include "SHA1.H"

// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::profileCode::profileCode(const dictionary& dict, const Time& runTime)
{
    if (!dict.readIfPresent("code", code_)) return;
    if (!dynamicCode::allowSystemOperations)
    {
        FatalIOErrorInFunction(dict)
            << "Entry code would be compiled, but allowSystemOperations is 0 in"
            << " the InfoSwitches of controlDict" << exit(FatalIOError);
    }

    const word name("nodalProfile_" + SHA1(code_).digest().str());
    const fileName dir(runTime.globalPath()/"dynamicCode");
    const fileName library(dir/(name + ".so"));

    if (Pstream::master() && !isFile(library, false))
    {
        mkDir(dir);
        {
            OFstream os(dir/(name + ".C"));
            os.writeQuoted
            (
                "#include <cmath>\nusing namespace std;\nextern \"C\" void " + name
              + "(const double* x, const double t, double* u)\n{\n" + code_ + "\n}\n",
                false
            );
        }
        const string stem("\"" + dir/name);
        if (Foam::system("g++ -O2 -shared -fPIC -o " + stem + ".so\" " + stem + ".C\""))
        {
            FatalIOErrorInFunction(dict)
                << "Entry code does not compile, see the compiler's message"
                << " above; the file is " << dir/(name + ".C") << nl
                << "Expected the body of a function of x[0..2] (m) and t (s)"
                << " that sets u[0..2]" << exit(FatalIOError);
        }
    }
    returnReduce(1, sumOp<label>());

    void* handle = dlOpen(library);
    if (handle) function_ = reinterpret_cast<function>(dlSym(handle, name));
    if (!function_)
    {
        FatalIOErrorInFunction(dict)
            << "Could not load " << library << exit(FatalIOError);
    }
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::profileCode::write(Ostream& os) const
{
    if (empty()) return;
    os.writeKeyword("code") << token::HASH << token::BEGIN_BLOCK;
    os.writeQuoted(code_, false)
        << token::HASH << token::END_BLOCK << token::END_STATEMENT << nl;
}


// ************************************************************************* //
