/*---------------------------------------------------------------------------*\
    monolithicFoam: finite-element fluid-structure interaction for OpenFOAM
    Copyright (C) 2026 the monolithicFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "restartFields.H"
#include "SortableList.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

Foam::IOobject Foam::restartFields::io
(
    const word& name,
    const IOobject::readOption read
) const
{
    const fvMesh& mesh = region_.mesh();
    return IOobject("restart." + name, mesh.time().timeName(), mesh, read, IOobject::NO_WRITE, false);
}


Foam::word Foam::restartFields::cellName(const word& part, const label k) const
{
    return word(part + '.' + Foam::name(k));
}


template<class Type>
void Foam::restartFields::write
(
    const word& part,
    const Field<Type>& values,
    const place at
) const
{
    if (at == place::CELLS)
    {
        GeometricField<Type, fvPatchField, volMesh> atCells
        (
            io(part, IOobject::NO_READ), region_.mesh(), dimensioned<Type>(dimless, Zero)
        );
        atCells.primitiveFieldRef() = values;
        atCells.write();
        return;
    }
    typedef GeometricField<Type, pointPatchField, pointMesh> pointFieldType;
    const feMesh& fe = region_.fe();

    pointFieldType atPoints
    (
        io(part, IOobject::NO_READ), pointMesh::New(region_.mesh()), dimensioned<Type>(dimless, Zero)
    );
    fe.toPoints<Type>(values, atPoints.primitiveFieldRef());
    atPoints.write();
    if (at != place::NODES) return;

    const label n = perTensor<Type>(), nCmpts = pTraits<Type>::nComponents;
    for (label k = 0; k < nTensors<Type>(); ++k)
    {
        volTensorField atCells
        (
            io(cellName(part, k), IOobject::NO_READ), region_.mesh(), dimensionedTensor(dimless, Zero)
        );
        forAll(midNodes_, c) for (label i = k*n; i < min((k + 1)*n, midNodes_[c].size()); ++i)
        {
            for (label a = 0; a < nCmpts; ++a)
            {
                atCells[c][(i - k*n)*nCmpts + a] = component(values[midNodes_[c][i]], a);
            }
        }
        atCells.write();
    }
}


template<class Type>
void Foam::restartFields::read
(
    const word& part,
    Field<Type>& values,
    const place at
) const
{
    if (at == place::CELLS)
    {
        values = GeometricField<Type, fvPatchField, volMesh>
        (
            io(part, IOobject::MUST_READ), region_.mesh()
        ).primitiveField();
        return;
    }
    typedef GeometricField<Type, pointPatchField, pointMesh> pointFieldType;
    const feMesh& fe = region_.fe();

    const pointFieldType atPoints(io(part, IOobject::MUST_READ), pointMesh::New(region_.mesh()));
    for (label n = 0; n < fe.nVertices(); ++n) values[n] = atPoints[fe.vertexPoint()[n]];
    if (at != place::NODES) return;

    const label n = perTensor<Type>(), nCmpts = pTraits<Type>::nComponents;
    for (label k = 0; k < nTensors<Type>(); ++k)
    {
        const volTensorField atCells(io(cellName(part, k), IOobject::MUST_READ), region_.mesh());
        forAll(midNodes_, c) for (label i = k*n; i < min((k + 1)*n, midNodes_[c].size()); ++i)
        {
            for (label a = 0; a < nCmpts; ++a)
            {
                setComponent(values[midNodes_[c][i]], a) = atCells[c][(i - k*n)*nCmpts + a];
            }
        }
    }
}


template<class F>
void Foam::restartFields::forLists(const F& f) const
{
    for (const statePart& part : region_.state().parts())
    {
        // What is on bodies, their nodes tell
        if (part.on() == fieldLayout::support::BODIES) continue;
        const HashTable<vectorField*> vectors(part.vectors());
        const HashTable<scalarField*> scalars(part.scalars());
        typedef fieldLayout::support on;
        const place at =
            part.on() == on::CELLS ? place::CELLS
          : part.on() == on::NODES && region_.fe().order() == 2 ? place::NODES : place::VERTICES;
        const auto any = [](const label n) { return returnReduce(n, sumOp<label>()) > 0; };
        for (const word& name : vectors.sortedToc())
        {
            if (any(vectors[name]->size())) f(name, *vectors[name], at);
        }
        for (const word& name : scalars.sortedToc())
        {
            if (any(scalars[name]->size())) f(name, *scalars[name], at);
        }
    }
}


// * * * * * * * * * * * * * * * * Constructors  * * * * * * * * * * * * * * //

Foam::restartFields::restartFields(feRegion& region)
:
    region_(region),
    midNodes_(region.mesh().nCells()),
    nMid_(0)
{
    const feMesh& fe = region.fe();
    const vector along(1, 0.6180339887, 0.4142135624);
    for (const elementBlock& block : fe.blocks()) for (label e = 0; e < block.size(); ++e)
    {
        const SubList<label> mid
        (
            block.nodes, block.nNodes - block.nVertices(), e*block.nNodes + block.nVertices()
        );
        SortableList<scalar> distance(mid.size());
        forAll(mid, i) distance[i] = along & fe.points()[mid[i]];
        distance.sort();
        labelList& nodes = midNodes_[block.cells[e]];
        nodes = labelList(UIndirectList<label>(mid, distance.indices()));
        nMid_ = max(nMid_, nodes.size());
    }
    reduce(nMid_, maxOp<label>());
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::restartFields::write() const
{
    const unsigned digits = IOstream::defaultPrecision(17);
    forLists([&](const word& name, const auto& list, const place at) { write(name, list, at); });
    IOstream::defaultPrecision(digits);
}


bool Foam::restartFields::found() const
{
    bool all = true;
    forLists([&](const word& name, const auto& list, const place at)
    {
        typedef typename std::decay<decltype(list[0])>::type Type;
        all = all && isFile(io(name, IOobject::MUST_READ).objectPath());
        if (at != place::NODES) return;
        for (label k = 0; k < nTensors<Type>(); ++k)
        {
            all = all && isFile(io(cellName(name, k), IOobject::MUST_READ).objectPath());
        }
    });
    return all;
}


void Foam::restartFields::read()
{
    forLists([&](const word& name, auto& list, const place at) { read(name, list, at); });
}


// ************************************************************************* //
