// SPDX-License-Identifier: MIT
// The few controls that every panel is made of; each is labelled and reachable by keyboard.
import type { ComponentChildren } from 'preact';
import { useState } from 'preact/hooks';
import { Icon, type IconName } from './icons';

export function IconButton(props: { icon: IconName; label: string; onClick: () => void; pressed?: boolean; disabled?: boolean }) {
  return (
    <button
      type="button"
      class="icon-button"
      aria-label={props.label}
      title={props.label}
      {...(props.pressed === undefined ? {} : { 'aria-pressed': props.pressed })}
      disabled={props.disabled ?? false}
      onClick={props.onClick}
    >
      <Icon name={props.icon} />
    </button>
  );
}

export function Button(props: { onClick: () => void; disabled?: boolean; children: ComponentChildren }) {
  return (
    <button type="button" class="button" disabled={props.disabled ?? false} onClick={props.onClick}>
      {props.children}
    </button>
  );
}

export function Switch(props: { label: string; on: boolean; onChange: (on: boolean) => void }) {
  return (
    <label class="switch">
      <input type="checkbox" role="switch" checked={props.on} onChange={(e) => props.onChange(e.currentTarget.checked)} />
      <span>{props.label}</span>
    </label>
  );
}

export function Choice<T extends string>(props: { label: string; value: T; options: [T, string][]; onChange: (value: T) => void }) {
  return (
    <label class="field">
      <span>{props.label}</span>
      <select value={props.value} onChange={(e) => props.onChange(e.currentTarget.value as T)}>
        {props.options.map(([value, text]) => (
          <option key={value} value={value}>
            {text}
          </option>
        ))}
      </select>
    </label>
  );
}

/** `onInput` while it moves, `onChange` once when it is let go. */
export function Slider(props: {
  label: string;
  value: number;
  min: number;
  max: number;
  step: number;
  show?: (value: number) => string;
  onInput?: (value: number) => void;
  onChange: (value: number) => void;
}) {
  const [moving, setMoving] = useState<number | null>(null);
  const value = moving ?? props.value;
  return (
    <label class="field slider">
      <span>
        {props.label}
        <output>{props.show ? props.show(value) : value.toFixed(2)}</output>
      </span>
      <input
        type="range"
        min={props.min}
        max={props.max}
        step={props.step}
        value={value}
        onInput={(e) => {
          setMoving(Number(e.currentTarget.value));
          props.onInput?.(Number(e.currentTarget.value));
        }}
        onChange={(e) => {
          setMoving(null);
          props.onChange(Number(e.currentTarget.value));
        }}
      />
    </label>
  );
}

export function Section(props: { title: string; open?: boolean; children: ComponentChildren }) {
  return (
    <details class="section" open={props.open ?? false}>
      <summary>{props.title}</summary>
      <div class="section-body">{props.children}</div>
    </details>
  );
}
