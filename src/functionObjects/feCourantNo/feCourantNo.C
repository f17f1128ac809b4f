/*---------------------------------------------------------------------------*\
    monolithicFoam: finite-element fluid-structure interaction for OpenFOAM
    Copyright (C) 2026 the monolithicFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "feCourantNo.H"
#include "feValues.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace functionObjects
{
    defineTypeNameAndDebug(feCourantNo, 0);
    addToRunTimeSelectionTable(functionObject, feCourantNo, dictionary);
}
}


// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

//- Elements that are crossed in a second by a velocity c at the centre
template<class E>
static scalar crossings(const feMesh& fe, const label* nodes, const vectorField& x, const vectorField& c)
{
    constexpr int dim = E::dim;
    double centre[dim] = {}, N[E::nNodes], dN[E::nNodes][dim];
    for (int i = 0; i < E::nVertices; ++i) for (int a = 0; a < dim; ++a)
    {
        centre[a] += E::xi[i][a]/E::nVertices;
    }
    E::shape(centre, N, dN);

    Ten<double, dim> J = Ten<double, dim>::zero();
    Vec<double, dim> v = Vec<double, dim>::zero();
    for (int i = 0; i < E::nNodes; ++i) for (int a = 0; a < dim; ++a)
    {
        v[a] += N[i]*c[nodes[i]][fe.axis(a)];
        for (int b = 0; b < dim; ++b) J(a, b) += x[nodes[i]][fe.axis(a)]*dN[i][b];
    }
    const Vec<double, dim> crossed = inv(J, det(J)) & v;
    scalar sum = 0;
    for (int b = 0; b < dim; ++b) sum += mag(crossed[b]);
    return E::nVertices == dim + 1 ? sum : sum/2;
}

} // End namespace Foam


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::functionObjects::feCourantNo::feCourantNo
(
    const word& name,
    const Time& runTime,
    const dictionary& dict
)
:
    feFunctionObject(name, runTime, dict, typeName),
    Co_(IOobject("Co", runTime.timeName(), mesh_), mesh_, dimensionedScalar(dimless, Zero)),
    mean_(0),
    max_(0)
{
    read(dict);
    writeHeader(file(), "Courant number");
    writeColumns(file(), {"mean", "max"});
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::functionObjects::feCourantNo::read(const dictionary& dict)
{
    feFunctionObject::read(dict);
    reportUnknownEntries(dict, wordList());
    if (!nodal<vector>("pointU"))
    {
        FatalIOErrorInFunction(dict)
            << "Region " << mesh_.name() << " is no fluid, which could have a Courant number" << exit(FatalIOError);
    }
    return true;
}


bool Foam::functionObjects::feCourantNo::execute()
{
    const feMesh& fe = region().fe();
    const vectorField x(positions()), c(*nodal<vector>("pointU") - region().motion().v);
    const scalar deltaT = region().timeScheme().deltaT();
    for (const elementBlock& block : fe.blocks()) withElement(block, [&](auto tag)
    {
        typedef decltype(tag) E;
        if (E::dim != fe.dim()) return;
        for (label e = 0; e < block.size(); ++e)
        {
            Co_[block.cells[e]] = deltaT*crossings<E>(fe, block.element(e), x, c);
        }
    });
    mean_ = gAverage(Co_.primitiveField());
    max_ = gMax(Co_.primitiveField());
    setResult("mean", mean_);
    setResult("max", max_);
    return true;
}


bool Foam::functionObjects::feCourantNo::write()
{
    Log << type() << " " << name() << " write:" << nl
        << "    Courant number mean " << mean_ << ", max " << max_ << nl << endl;
    writeRow(file(), {mean_, max_});
    return Co_.write();
}


// ************************************************************************* //
