#include "simcore/base/scratch.h"

#include <thread>

#include <gtest/gtest.h>

using namespace simcore;

TEST(ScratchTest, GivesTheSameRoomAgain) {
    const double* first = nullptr;
    for (int k = 0; k < 3; ++k) {
        Scratch room;
        Scratch::Vector v = room.vector(10);
        v.setConstant(k);
        first = first == nullptr ? v.data() : first;
        EXPECT_EQ(v.data(), first);
        EXPECT_EQ(v, Eigen::VectorXd::Constant(10, k));
    }
}

// However much is asked for, what was given before stays where it is and as it is.
TEST(ScratchTest, WhatWasGivenStays) {
    Scratch outer;
    Scratch::Vector kept = outer.vector(Eigen::VectorXd::LinSpaced(100, 0.0, 99.0));
    for (const Eigen::Index size : {10, 1000, 2000, 100, 3000}) {
        Scratch inner;
        Scratch::Matrix big = inner.matrix(size, size / 10);
        big.setConstant(-1.0);
        const auto flags = inner.list<bool>(7);
        EXPECT_EQ(flags.size(), 7u);
        for (const bool flag : flags) {
            EXPECT_FALSE(flag);
        }
        Scratch::Vector small = inner.vector(3);
        small.setConstant(2.0);
        EXPECT_EQ(big.minCoeff(), -1.0);
        EXPECT_EQ(big.maxCoeff(), -1.0);
    }
    Scratch::Vector more = outer.vector(5);
    more.setZero();
    EXPECT_EQ(kept, Eigen::VectorXd::LinSpaced(100, 0.0, 99.0));
}

TEST(ScratchTest, EachThreadHasItsOwn) {
    Scratch room;
    Scratch::Vector here = room.vector(4);
    here.setConstant(1.0);
    std::thread([&here] {
        Scratch itsOwn;
        Scratch::Vector there = itsOwn.vector(4);
        EXPECT_NE(there.data(), here.data());
        there.setConstant(2.0);
    }).join();
    EXPECT_EQ(here, Eigen::VectorXd::Ones(4));
}
