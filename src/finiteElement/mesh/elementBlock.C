/*---------------------------------------------------------------------------*\
    monolithicFoam: finite-element fluid-structure interaction for OpenFOAM
    Copyright (C) 2026 the monolithicFoam authors
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "elementBlock.H"
#include "DynamicList.H"
#include <cstdint>
#include <vector>

const char* Foam::elementName(const elementShape shape)
{
    static const char* names[] =
        {"line", "tri", "quad", "tet", "hex", "prism", "pyramid"};
    return names[int(shape)];
}


void Foam::elementBlock::colour(const label nMeshNodes)
{
    // Bit c of a node: a batch of colour c has it
    std::vector<std::uint64_t> used(nMeshNodes, 0);
    DynamicList<DynamicList<label>> batches;

    for (label batch = 0; batch < nBatches(); ++batch)
    {
        std::uint64_t taken = 0;
        for (int l = 0; l < nLanes(batch); ++l)
        {
            const label* nodes = element(lane(batch, l));
            for (label i = 0; i < nNodes; ++i) taken |= used[nodes[i]];
        }
        label c = 0;
        while (c < 63 && (taken >> c & 1)) ++c;

        for (int l = 0; l < nLanes(batch); ++l)
        {
            const label* nodes = element(lane(batch, l));
            for (label i = 0; i < nNodes; ++i) used[nodes[i]] |= std::uint64_t(1) << c;
        }
        if (c >= batches.size()) batches.setSize(c + 1);
        batches[c].append(batch);
    }

    // More than 63 colours: the batches of the last are done one by one
    colours.clear();
    forAll(batches, c)
    {
        if (c < 63) colours.append(labelList(batches[c]));
        else for (const label b : batches[c]) colours.append(labelList(1, b));
    }
}
