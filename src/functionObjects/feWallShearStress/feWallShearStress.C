/*---------------------------------------------------------------------------*\
    monolithicFoam: finite-element fluid-structure interaction for OpenFOAM
    Copyright (C) 2026 the monolithicFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "feWallShearStress.H"
#include "wallPolyPatch.H"
#include "addToRunTimeSelectionTable.H"

// * * * * * * * * * * * * * * Static Data Members * * * * * * * * * * * * * //

namespace Foam
{
namespace functionObjects
{
    defineTypeNameAndDebug(feWallShearStress, 0);
    addToRunTimeSelectionTable(functionObject, feWallShearStress, dictionary);
}
}


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::labelList Foam::functionObjects::feWallShearStress::readPatches
(
    const dictionary& dict
) const
{
    if (dict.found("patches"))
    {
        return region().fe().patchIndices(dict.get<wordRes>("patches"), dict);
    }

    const polyBoundaryMesh& patches = mesh_.boundaryMesh();
    const labelList walls(patches.findPatchIDs<wallPolyPatch>().sortedToc());
    if (walls.empty())
    {
        FatalIOErrorInFunction(dict)
            << "Region " << mesh_.name() << " has no patch of type wall, and"
            << " there is no entry patches. Its patches are " << patches.names()
            << exit(FatalIOError);
    }
    return walls;
}


Foam::scalar Foam::functionObjects::feWallShearStress::mu() const
{
    const dictionary& transport = mesh_.lookupObject<IOdictionary>("transportProperties");
    return
        transport.found("mu")
      ? dimensionedScalar("mu", dimDynamicViscosity, transport).value()
      : rho()*dimensionedScalar("nu", dimViscosity, transport).value();
}


Foam::scalar Foam::functionObjects::feWallShearStress::rho() const
{
    const dictionary& transport = mesh_.lookupObject<IOdictionary>("transportProperties");
    return dimensionedScalar("rho", dimDensity, transport).value();
}


void Foam::functionObjects::feWallShearStress::findElements()
{
    if (!element_.empty()) return;

    const List<elementBlock>& blocks = region().fe().blocks();
    element_.setSize(mesh_.nCells());
    forAll(blocks, b) forAll(blocks[b].cells, e) element_[blocks[b].cells[e]] = labelPair(b, e);
}


template<class E>
Foam::tensor Foam::functionObjects::feWallShearStress::gradient
(
    const label* nodes,
    const labelUList& vertices,
    const vectorField& x,
    const vectorField& v
) const
{
    const feMesh& fe = region().fe();
    double centre[E::dim] = {}, N[E::nNodes], dN[E::nNodes][E::dim];
    for (int i = 0; i < E::nVertices; ++i)
    {
        if (!vertices.found(nodes[i])) continue;
        for (int c = 0; c < E::dim; ++c) centre[c] += E::xi[i][c]/vertices.size();
    }
    E::shape(centre, N, dN);

    // dx_i/dxi_c and dv_i/dxi_c; with the unit vector out of plane
    tensor dx(Zero), dv(Zero);
    for (int c = E::dim; c < 3; ++c) dx(fe.axis(c), c) = 1;
    for (int i = 0; i < E::nNodes; ++i)
    {
        for (int c = 0; c < E::dim; ++c) for (int a = 0; a < E::dim; ++a)
        {
            dx(fe.axis(a), c) += x[nodes[i]][fe.axis(a)]*dN[i][c];
            dv(fe.axis(a), c) += v[nodes[i]][fe.axis(a)]*dN[i][c];
        }
    }
    return (dv & inv(dx)).T();
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::functionObjects::feWallShearStress::feWallShearStress
(
    const word& name,
    const Time& runTime,
    const dictionary& dict
)
:
    feFunctionObject(name, runTime, dict, typeName),
    tau_
    (
        IOobject("wallShearStress", runTime.timeName(), mesh_),
        mesh_,
        dimensionedVector(dimPressure, Zero)
    ),
    yPlus_(IOobject("yPlus", runTime.timeName(), mesh_), mesh_, dimensionedScalar(dimless, Zero))
{
    read(dict);

    writeHeader(file(), "Magnitude of the wall shear stress, Pa; largest y+");
    wordList columns;
    for (const label patchi : patches_)
    {
        columns.append(mesh_.boundaryMesh()[patchi].name() + ".min");
        columns.append(mesh_.boundaryMesh()[patchi].name() + ".max");
        columns.append(mesh_.boundaryMesh()[patchi].name() + ".yPlus");
    }
    writeColumns(file(), columns);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

bool Foam::functionObjects::feWallShearStress::read(const dictionary& dict)
{
    feFunctionObject::read(dict);
    reportUnknownEntries(dict, {"patches"});

    if (!nodal<vector>("pointU"))
    {
        FatalIOErrorInFunction(dict)
            << "Region " << mesh_.name() << " has no velocity pointU: it is no"
            << " fluid" << exit(FatalIOError);
    }
    patches_ = readPatches(dict);

    return true;
}


bool Foam::functionObjects::feWallShearStress::execute()
{
    const feMesh& fe = region().fe();
    const vectorField& v = *nodal<vector>("pointU");
    const vectorField x(fe.points() + *nodal<vector>("pointDisplacement"));
    const scalar mu = this->mu(), rho = this->rho();
    findElements();

    for (const label patchi : patches_)
    {
        const vectorField n(mesh_.boundary()[patchi].nf());
        const labelUList& faceCells = mesh_.boundary()[patchi].faceCells();
        vectorField& tau = tau_.boundaryFieldRef()[patchi];
        scalarField& yPlus = yPlus_.boundaryFieldRef()[patchi];

        for (const elementBlock& faces : fe.patchBlocks(patchi))
        {
            const labelUList& nodes = faces.nodes;
            const label nVertices =
                faces.shape == elementShape::LINE ? 2
              : faces.shape == elementShape::TRI ? 3 : 4;
            forAll(faces.cells, f)
            {
                const label facei = faces.cells[f];
                const labelPair& at = element_[faceCells[facei]];
                const elementBlock& block = fe.blocks()[at.first()];
                const SubList<label> vertices(nodes, nVertices, f*faces.nNodes);
                withElement(block, [&](auto E)
                {
                    const tensor gradV = gradient<decltype(E)>
                    (
                        block.element(at.second()), vertices, x, v
                    );
                    const vector t = mu*((gradV + gradV.T()) & n[facei]);
                    tau[facei] = t - (t & n[facei])*n[facei];
                });

                // The nearest node that is not on the wall
                scalar y = GREAT;
                for (label i = 0; i < block.nNodes; ++i)
                {
                    const vector r = x[vertices[0]] - x[block.element(at.second())[i]];
                    if ((r & n[facei]) > 1e-3*mag(r)) y = min(y, r & n[facei]);
                }
                yPlus[facei] = mu > 0 ? y*::sqrt(rho*mag(tau[facei]))/mu : 0;
            }
        }
    }
    return true;
}


bool Foam::functionObjects::feWallShearStress::write()
{
    Log << type() << " " << name() << " write:" << nl;

    scalarList row;
    for (const label patchi : patches_)
    {
        const word& patch = mesh_.boundaryMesh()[patchi].name();
        const scalarField size(mag(tau_.boundaryField()[patchi]));
        const scalar smallest = gMin(size), largest = gMax(size);
        const scalar yPlus = gMax(yPlus_.boundaryField()[patchi]);

        Log << "    min/max(" << patch << ") = " << smallest << ", " << largest << ", y+ " << yPlus << nl;
        setResult(patch + ".yPlus", yPlus);
        setResult(patch + ".min", smallest);
        setResult(patch + ".max", largest);
        row.append(smallest);
        row.append(largest);
        row.append(yPlus);
    }
    Log << endl;

    writeRow(file(), row);
    return tau_.write() && yPlus_.write();
}


// ************************************************************************* //
