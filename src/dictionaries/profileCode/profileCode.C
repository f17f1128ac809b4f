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

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::profileCode::compile
(
    const dictionary& dict,
    const fileName& dir,
    const word& name
) const
{
    // Files get their names when they are complete: other runs of the case may
    // be at the same point
    const fileName source(dir/(name + ".C")), library(dir/(name + ".so"));
    const word own("." + hostName() + "_" + Foam::name(pid()));

    mkDir(dir);
    {
        OFstream os(source + own);
        os.writeQuoted
        (
            "#include <cmath>\n#include <complex>\nusing namespace std;\nextern \"C\" void " + name
          + "(const double* x, const double t, double* u)\n{\n" + code_ + "\n}\n",
            false
        );
    }
    mv(source + own, source);

    // Without a shell, so that no character of a path has a meaning
    const List<string> command
    ({
        "g++", "-O2", "-shared", "-fPIC", "-o", library + own, source
    });
    if (Foam::system(command))
    {
        FatalIOErrorInFunction(dict)
            << "Entry " << keyword_ << " does not compile, see the compiler's message"
            << " above; the file is " << source << nl
            << "Expected the body of a function of x[0..2] (m) and t (s)"
            << " that sets u[0..2]" << exit(FatalIOError);
    }
    mv(library + own, library);
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::profileCode::profileCode
(
    const dictionary& dict,
    const Time& runTime,
    const word& keyword
)
:
    keyword_(keyword)
{
    if (!dict.readIfPresent(keyword_, code_)) return;
    if (!dynamicCode::allowSystemOperations)
    {
        FatalIOErrorInFunction(dict)
            << "Entry " << keyword_ << " would be compiled, but allowSystemOperations is 0 in"
            << " the InfoSwitches of controlDict" << exit(FatalIOError);
    }

    const word name("nodalProfile_" + SHA1(code_).digest().str());
    const fileName dir(runTime.globalPath()/"dynamicCode");
    const fileName library(dir/(name + ".so"));

    if (Pstream::master() && !isFile(library, false)) compile(dict, dir, name);
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
    os.writeKeyword(keyword_) << token::HASH << token::BEGIN_BLOCK;
    os.writeQuoted(code_, false)
        << token::HASH << token::END_BLOCK << token::END_STATEMENT << nl;
}


// ************************************************************************* //
