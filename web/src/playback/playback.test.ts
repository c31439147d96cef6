import { effect, signal } from "@preact/signals";
import { describe, expect, it } from "vitest";
import { createPlayback } from "./playback";

describe("playback", () => {
  it("plays to the end, stops there, and play starts over", () => {
    const playback = createPlayback(signal(2));
    playback.play();
    playback.tick(1.5);
    expect(playback.time.value).toBe(1.5);
    playback.tick(1);
    expect(playback.time.value).toBe(2);
    expect(playback.isPlaying.value).toBe(false);
    playback.toggle();
    expect(playback.time.value).toBe(0);
    expect(playback.isPlaying.value).toBe(true);
  });

  it("half the speed takes twice as long", () => {
    const playback = createPlayback(signal(10));
    playback.speed.value = 0.5;
    playback.play();
    playback.tick(1);
    expect(playback.time.value).toBe(0.5);
  });

  it("loops over the range, and over the whole show without one", () => {
    const playback = createPlayback(signal(10));
    playback.isLooping.value = true;
    playback.range.value = { from: 2, to: 4 };
    playback.play();
    expect(playback.time.value).toBe(2);
    playback.tick(3);
    expect(playback.time.value).toBe(3);
    playback.range.value = null;
    playback.tick(9);
    expect(playback.time.value).toBe(2);
  });

  it("a range is left alone when not looping", () => {
    const playback = createPlayback(signal(10));
    playback.range.value = { from: 2, to: 4 };
    playback.play();
    playback.tick(6);
    expect(playback.time.value).toBe(6);
  });

  it("a paused playhead stays where it is", () => {
    const playback = createPlayback(signal(10));
    playback.seek(3);
    playback.tick(1);
    expect(playback.time.value).toBe(3);
  });

  it("seeking stays within the show, and a show cut shorter takes the playhead along", () => {
    const duration = signal(10);
    const playback = createPlayback(duration);
    playback.seek(99);
    expect(playback.time.value).toBe(10);
    duration.value = 4;
    expect(playback.time.value).toBe(4);
    playback.seek(-1);
    expect(playback.time.value).toBe(0);
  });

  it("followers hear of every change of the time until they stop, and of whatever else they read of none", () => {
    const playback = createPlayback(signal(10));
    const other = signal(0);
    const heard: number[] = [];
    const stop = playback.follow((time) => heard.push(time + other.value));
    const seeking = signal(4);
    effect(() => playback.seek(seeking.value));
    playback.play();
    playback.tick(1);
    other.value = 100;
    expect(heard).toEqual([4, 4, 5]);
    stop();
    playback.seek(9);
    expect(heard).toEqual([4, 4, 5]);
  });

  it("a show of one moment does not play", () => {
    const playback = createPlayback(signal(0));
    playback.play();
    expect(playback.isPlaying.value).toBe(false);
  });
});
