/*---------------------------------------------------------------------------*\
    monolithicFoam: finite-element fluid-structure interaction for OpenFOAM
    Copyright (C) 2026 the monolithicFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "feForces.H"
#include "emptyPolyPatch.H"
#include "processorPolyPatch.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace functionObjects
{
    defineTypeNameAndDebug(feForces, 0);
    addToRunTimeSelectionTable(functionObject, feForces, dictionary);
}
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::labelList Foam::functionObjects::feForces::matching
(
    const wordRe& name
) const
{
    DynamicList<label> found;
    DynamicList<word> names;
    for (const polyPatch& pp : mesh_.boundaryMesh())
    {
        if (isA<processorPolyPatch>(pp) || isA<emptyPolyPatch>(pp)) continue;
        names.append(pp.name());
        if (name.match(pp.name())) found.append(pp.index());
    }
    if (found.empty())
    {
        FatalIOErrorInFunction(dict_)
            << "Region " << mesh_.name() << " has no patch " << name
            << ". Its patches are " << names << exit(FatalIOError);
    }
    return labelList(found);
}


Foam::labelList Foam::functionObjects::feForces::nodes() const
{
    const feMesh& fe = region().fe();

    labelHashSet found;
    for (const wordRe& name : patches_)
    {
        for (const label patchi : matching(name)) found.insert(fe.patchNodes(patchi));
    }
    if (!Pstream::parRun()) return found.sortedToc();

    // Nodes that other ranks may have too
    boolList shared(fe.nNodes(), false);
    for (const polyPatch& pp : mesh_.boundaryMesh())
    {
        if (!isA<processorPolyPatch>(pp)) continue;
        for (const label p : pp.meshPoints())
        {
            if (fe.pointNode()[p] >= 0) shared[fe.pointNode()[p]] = true;
        }
    }
    List<labelList> parent;
    fe.parents(parent);
    for (label n = fe.nVertices(); n < fe.nNodes(); ++n)
    {
        shared[n] = true;
        for (const label m : parent[n]) shared[n] = shared[n] && shared[m];
    }

    DynamicList<label> keys;
    for (const label n : found) if (shared[n]) keys.append(fe.key()[n]);
    List<labelList> allKeys(Pstream::nProcs());
    allKeys[Pstream::myProcNo()] = keys;
    Pstream::gatherList(allKeys);
    Pstream::scatterList(allKeys);

    labelHashSet onPatches;
    for (const labelList& k : allKeys) onPatches.insert(k);
    forAll(shared, n) if (shared[n] && onPatches.found(fe.key()[n])) found.insert(n);
    return found.sortedToc();
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::functionObjects::feForces::feForces
(
    const word& name,
    const Time& runTime,
    const dictionary& dict
)
:
    feFunctionObject(name, runTime, dict, "forces"),
    CofR_(Zero),
    force_(Zero),
    moment_(Zero)
{
    read(dict);

    writeHeader(file(), "Force (N) and moment (N m), in 2-D per metre of depth");
    writeHeaderValue(file(), "CofR", CofR_);
    writeColumns(file(), {"fx", "fy", "fz", "mx", "my", "mz"});
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::functionObjects::feForces::read(const dictionary& dict)
{
    feFunctionObject::read(dict);

    dict.readEntry("patches", patches_);
    CofR_ = dict.lookupOrDefault<point>("CofR", Zero);
    for (const wordRe& name : patches_) matching(name);

    return true;
}


bool Foam::functionObjects::feForces::execute()
{
    const feMesh& fe = region().fe();
    const vectorField& R = region().force();
    const vectorField x(positions());

    force_ = moment_ = Zero;
    for (const label n : nodes())
    {
        vector r = x[n] - CofR_;
        if (fe.dim() == 2) r[fe.axis(2)] = 0;
        force_ -= R[n];
        moment_ -= r ^ R[n];
    }
    reduce(force_, sumOp<vector>());
    reduce(moment_, sumOp<vector>());

    setResult("forces", force_);
    setResult("moments", moment_);

    return true;
}


bool Foam::functionObjects::feForces::write()
{
    const vector &f = force_, &m = moment_;

    Log << type() << " " << name() << " write:" << nl
        << "    Sum of forces" << nl
        << "        Total    : " << f << nl
        << "    Sum of moments" << nl
        << "        Total    : " << m << nl << endl;

    writeRow(file(), {f.x(), f.y(), f.z(), m.x(), m.y(), m.z()});
    return true;
}


// ************************************************************************* //
